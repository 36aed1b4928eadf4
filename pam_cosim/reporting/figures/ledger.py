"""The ledger as a map: which balance fails, by how much, and where."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pam_cosim.ledger import BalanceEntry, Ledger, binned, mapped
from pam_cosim.model.domain import Domain
from pam_cosim.reporting.account.ledger_words import against_of, telling_entries
from pam_cosim.reporting.style import BAND, INK, SOFT, balance_colours, message, new_figure
from pam_cosim.units import readable_factor, readable_unit


def ledger_figure(ledger: Ledger) -> Figure:
    """Above, the share of each balance. Below, a row a balance: in time, against its variables, and on a plane."""
    rows, domain = telling_entries(ledger), ledger.domain
    colours = _colours(ledger)
    figure = new_figure(11.0, 1.4 + 2.3 * max(len(rows), 1))
    grid = figure.add_gridspec(
        1 + max(len(rows), 1), 4, height_ratios=[0.55] + [1.0] * max(len(rows), 1)
    )
    draw_shares(figure.add_subplot(grid[0, :]), ledger)
    for i, entry in enumerate(rows):
        colour = colours[entry.balance]
        draw_terms(figure.add_subplot(grid[i + 1, 0]), entry, colour)
        names = against_of(entry, domain)[:2]
        for k in range(2):
            axes = figure.add_subplot(grid[i + 1, 1 + k])
            if k < len(names):
                draw_against(axes, entry, names[k], colour)
            else:
                message(axes, "no further variable")
        draw_map(figure.add_subplot(grid[i + 1, 3]), entry, domain)
    if not rows:
        message(figure.add_subplot(grid[1, :]), "the model has no place for a missing term")
    return figure


def draw_shares(axes: Axes, ledger: Ledger) -> None:
    """What is lost without each balance in the best explanation, as one bar."""
    position, colours = 0.0, _colours(ledger)
    for entry in ledger.entries:
        if entry.share > 0:
            axes.barh(0, entry.share, left=position, color=colours[entry.balance], height=0.6)
            if entry.share > 0.08:
                text = f"{entry.balance} {100 * entry.share:.0f} %"
                axes.text(
                    position + entry.share / 2,
                    0,
                    text,
                    ha="center",
                    va="center",
                    color="white",
                    fontweight="bold",
                )
            position += entry.share
    if not position:
        message(axes, "no balance fails: the model meets the samples to the noise")
    failing = " and ".join(ledger.failing) or "nothing"
    axes.set_title(
        f"fails: {failing}. Mean square error {ledger.before:.3g} → {ledger.after:.3g} noise variances",
        loc="left",
        fontweight="bold",
    )
    axes.set_xlim(0, 1)
    axes.set_axis_off()


def draw_terms(axes: Axes, entry: BalanceEntry, colour: str = INK) -> None:
    """The missing term over time, every run, with two standard deviations."""
    factor, unit = _scale(entry)
    for term in entry.courses:
        low, high = ((term.value + s * 2 * term.deviation) * factor for s in (-1, 1))
        axes.fill_between(term.time, low, high, color=colour, alpha=0.12, lw=0)
        axes.plot(term.time, term.value * factor, color=colour, lw=0.8)
    axes.axhline(0, color=SOFT, lw=0.8)
    _bound(axes, entry, factor)
    axes.set_xlabel("time [s]")
    axes.set_ylabel(f"missing {entry.balance} [{unit}]")


def draw_against(axes: Axes, entry: BalanceEntry, name: str, colour: str = INK) -> None:
    """The missing term against one of its variables: every instant, and the means of bands."""
    factor, unit = _scale(entry)
    across = readable_factor(entry.units.get(name, ""))
    for term_of_run in entry.courses:
        axes.plot(
            term_of_run.against[name] * across,
            term_of_run.value * factor,
            ".",
            color=SOFT,
            ms=1.2,
            alpha=0.5,
            rasterized=True,
        )
    bands = binned(entry, name)
    at = np.array([(b.low + b.high) / 2 for b in bands]) * across
    mean, deviation = (
        np.array([b.mean for b in bands]) * factor,
        np.array([b.deviation for b in bands]) * factor,
    )
    axes.errorbar(at, mean, 2 * deviation, fmt="o-", color=colour, ms=3, lw=1.2, capsize=2)
    axes.axhline(0, color=SOFT, lw=0.8)
    _bound(axes, entry, factor)
    axes.set_xlabel(_named(entry, name))


def draw_map(axes: Axes, entry: BalanceEntry, domain: Domain) -> None:
    """Where the term is positive and where negative, in standard deviations, over the plane of two variables."""
    names = against_of(entry, domain)
    plane = next((p for p in domain.planes if p[0] in names and p[1] in names), None)
    if plane is None:
        message(axes, "one variable only: no plane")
        return
    cells = mapped(entry, *plane)
    fx, fy = (readable_factor(entry.units.get(n, "")) for n in plane)
    axes.set_facecolor(BAND)
    picture = axes.pcolormesh(
        cells.x_edges * fx,
        cells.y_edges * fy,
        cells.significance,
        cmap="RdBu_r",
        vmin=-6,
        vmax=6,
        rasterized=True,
    )
    axes.figure.colorbar(picture, ax=axes, label="in standard deviations")
    axes.set_xlabel(_named(entry, plane[0]))
    axes.set_ylabel(_named(entry, plane[1]))


def _colours(ledger: Ledger) -> dict[str, str]:
    return balance_colours(ledger.domain.balances, [e.balance for e in ledger.entries])


def _named(entry: BalanceEntry, name: str) -> str:
    unit = readable_unit(entry.units.get(name, ""))
    return f"{name} [{unit}]" if unit and unit != "1" else name


def _scale(entry: BalanceEntry) -> tuple[float, str]:
    return readable_factor(entry.unit), readable_unit(entry.unit)


def _bound(axes: Axes, entry: BalanceEntry, factor: float) -> None:
    """Keeps single instants without information from blowing up the axis."""
    values = np.concatenate([c.value for c in entry.courses]) * factor
    reach = 1.3 * float(np.quantile(np.abs(values), 0.99)) + 2 * factor * float(
        np.median(np.concatenate([c.deviation for c in entry.courses]))
    )
    if reach > 0:
        axes.set_ylim(-reach, reach)
