"""What must survive the end of the lab: the progress of each person, in a database and in files to take home.

`database` keeps it, in the tables of `schema`; `merging` unites what two windows or two labs have made of it;
`records` says how one lesson is written down, and `progress_file` is the file of a person. Only this room imports
SQLAlchemy.
"""
