"""Families of arms with closed forms, recognised from their axes, and functions that the forms share."""
