"""Processes that this one starts: workers, what watches over an FMU, interrupts and limits of memory."""
