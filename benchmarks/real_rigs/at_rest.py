"""Rival methods for points at rest."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from benchmarks.real_rigs.dynamic import Fitted
from benchmarks.real_rigs.rows import Course


def run_static(method: str, courses: Mapping[str, Sequence[Course]]) -> Fitted:
    """Boosting, or a polynomial whose degree is chosen by cross-validation in the fitted rows."""
    x = np.concatenate([c.inputs for c in courses["fitted"]])
    y = np.concatenate([c.measured for c in courses["fitted"]])
    model: Any
    if method == "boosting":
        from sklearn.ensemble import HistGradientBoostingRegressor

        model = HistGradientBoostingRegressor(random_state=0).fit(x, y)
        size, count = "defaults", sum(len(t[0].nodes) for t in model._predictors)
    else:
        model, size = _polynomial(x, y)
        count = model[-1].coef_.size + 1
    predicted = {
        r: {c.name: np.asarray(model.predict(c.inputs)) for c in own} for r, own in courses.items()
    }
    return Fitted(size, count, predicted)


def _polynomial(x: Any, y: Any) -> tuple[Any, str]:
    from sklearn.linear_model import RidgeCV
    from sklearn.model_selection import KFold, cross_val_score
    from sklearn.pipeline import make_pipeline
    from sklearn.preprocessing import PolynomialFeatures, StandardScaler

    def made(degree: int) -> Any:
        features = PolynomialFeatures(degree, include_bias=False)
        return make_pipeline(
            StandardScaler(), features, StandardScaler(), RidgeCV(np.logspace(-8, 2, 21))
        )

    folds = KFold(5, shuffle=True, random_state=0)
    scores = {
        d: cross_val_score(made(d), x, y, cv=folds, scoring="neg_mean_squared_error").mean()
        for d in (2, 3, 4)
    }
    degree = max(scores, key=lambda d: scores[d])
    return made(degree).fit(x, y), f"degree {degree}"
