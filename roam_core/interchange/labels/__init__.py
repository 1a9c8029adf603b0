"""What those who label data use: COCO's instances and CVAT's tracks, out and in."""
