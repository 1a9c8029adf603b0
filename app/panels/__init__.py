"""The forms around the picture: shapes, tracker, shape properties, tools, views, status."""
