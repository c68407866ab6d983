"""What a drawing becomes on the page: files that pages and readers can use."""
