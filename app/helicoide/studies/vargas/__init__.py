"""What the studies of Vargas 2013 share: arms, trajectories, runs, tables and charts."""
