"""After Effects: a script that makes masks and compositions."""
