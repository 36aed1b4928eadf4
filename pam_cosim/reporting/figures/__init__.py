"""Figures, one kind a module: data in, a picture out. Nothing is computed here but positions on paper."""
