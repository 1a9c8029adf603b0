"""Where the parts of the window lie: beside and above each other, in the column of panels, and how high."""
