namespace wold { void unused_cli() {} }
