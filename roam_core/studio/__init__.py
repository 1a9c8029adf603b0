"""Many shots and steps as one batch: what is to be done, where it runs, what was done, and templates for a farm."""
