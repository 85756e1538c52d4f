"""Families of arms that closed forms know, recognised from their axes, and what the forms share."""
