"""What shapes say without a picture: what is solved together, what their keys were computed from, how sure they are."""
