"""Recordings of the independent rig that begin in the middle: does the model leave as little as of the whole?"""
