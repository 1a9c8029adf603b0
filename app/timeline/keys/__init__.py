"""The rows of keys: painted, chosen, dragged and edited."""
