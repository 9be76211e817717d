"""Files that are not scenes: name, bytes, and the message after the name of the file. To add a case, add a line."""
from hostile_scenes import SCENE

TEXTS = [
    ("empty file", b"", ": is empty; a scene needs at least block, material or network, and time"),
    ("file of blanks", b"  \n\n \t \n", ": is empty; a scene needs at least block, material or network, and time"),
    ("list", b"- block\n- time\n", ":1:1: a scene is a map of keys such as 'block:' and 'time:', not a list"),
    ("plain text", b"Dear Sir or Madam,\nplease find enclosed\n",
     ":1:1: a scene is a map of keys such as 'block:' and 'time:', not 'Dear Sir or Madam, please find enclosed'"),
    ("binary file", b"\x89HDF\r\n\x1a\n\0\0\0", ":1:1: the byte 0x89 is not text; a scene is YAML in UTF-8"),
    ("zero byte", SCENE.encode().replace(b"edge: 0.01", b"edge: 0.\x0001"),
     ":2:55: the byte 0x00 is not text; a scene is YAML in UTF-8"),
    ("text in Latin-1", SCENE.encode().replace(b"a block", b"ein W\xfcrfel"),
     ":1:13: the byte 0xFC is not text; a scene is YAML in UTF-8"),
    ("text in UTF-16", SCENE.encode("utf-16"), ":1:1: the byte 0xFF is not text; a scene is YAML in UTF-8"),
    ("escape sequence", b"title: \x1b[2J\n", ":1:8: the control character 0x1B has no place in a scene; remove it"),
    ("control character above ASCII", "title: a\u009b2J\n".encode(),
     ":1:9: the control character 0x9B has no place in a scene; remove it"),
    ("quote too many", SCENE.encode().replace(b"title: a block", b'title: "a block""'),
     ":13:25: the text ends inside a quote; close it where it should end, or remove the quote that is one too many; "
     "the quotes of line 1 do not pair"),
    ("tab that indents", SCENE.encode().replace(b"  - {name", b"\t- {name"),
     ":8:1: a tab indents this line; YAML takes spaces only"),
    ("key given twice", SCENE.encode() + b"time: {end: 2}\n",
     ":14:1: the key 'time' was given already at scene.yaml:9:1; remove one of the two"),
    ("key given twice in a section", SCENE.encode().replace(b"end: 0.01", b"end: 0.01, end: 0.02"),
     ":9:19: the key 'end' was given already at scene.yaml:9:8; remove one of the two"),
    ("anchor", SCENE.encode().replace(b"{rate: 50}", b"&rate {rate: 50}"),
     ":10:7: YAML anchors and aliases (&name, *name) are not taken; write the value out, and put an expression "
     "that begins with * or & in quotes"),
    ("alias", SCENE.encode().replace(b"{rate: 50}", b"*rate"),
     ":10:7: YAML anchors and aliases (&name, *name) are not taken; write the value out, and put an expression "
     "that begins with * or & in quotes"),
    ("merge key", SCENE.encode().replace(b"{rate: 50}", b"{<<: {rate: 50}}"),
     ":10:8: coat.<<: unknown key; known here are rate"),
    ("tag", SCENE.encode().replace(b"end: 0.01", b"end: !!float 0.01"),
     ":9:13: YAML tags ('tag:yaml.org,2002:float') are not taken; write the value without a tag"),
    ("two documents", SCENE.encode() + b"---\n" + SCENE.encode(),
     ":14:1: a second document begins here; a scene is one document: remove '---' or '...'"),
    ("later YAML", b"%YAML 9.9\n---\n" + SCENE.encode(),
     ":1:1: not valid YAML: YAML major version too large; check brackets, colons and indentation here and just "
     "before, and put expressions in quotes"),
    ("list for a key", b"? [a, b]\n: 1\n",
     ":1:3: a key must be plain text, not a list or a map; is a bracket open that should be closed?"),
    ("open bracket", SCENE.encode().replace(b"[4, 4, 2]", b"[4, 4, 2"),
     ":2:75: this closing bracket is one too many, or one before it is missing or of the other kind"),
    ("bracket too many", SCENE.encode().replace(b"[4, 4, 2]", b"[4, 4, 2]]"),
     ":2:45: this closing bracket is one too many, or one before it is missing or of the other kind"),
    ("open quote", SCENE.encode().replace(b"title: a", b'title: "a'),
     ":13:25: the text ends inside a quote; close it where it should end, or remove the quote that is one too many; "
     "the quotes of line 1 do not pair"),
    ("colon in a plain value", SCENE.encode().replace(b"threshold: 0.02", b"threshold: x > 0 ? 1 : 2"),
     ":5:10: the bracket that opens here is not closed, or an expression in it needs quotes"),
    ("value that is indented too little", b"block:\n    cells: [1, 1, 1]\n  edge: 1\n",
     ":3:3: not valid YAML: end of map not found; check brackets, colons and indentation here and just before, "
     "and put expressions in quotes"),
    ("unknown escape", b'title: "\\q"\n',
     ":1:11: not valid YAML: unknown escape character: q; check brackets, colons and indentation here and just "
     "before, and put expressions in quotes"),
    ("nested too deep", b"title: " + b"[" * 60 + b"]" * 60 + b"\n",
     ":1:57: nested deeper than 50 levels; a scene needs fewer than 10"),
    ("nested four million deep", b"[" * 4_000_000,
     ":1:1: a key must be plain text, not a list or a map; is a bracket open that should be closed?"),
    ("nested four million deep in maps", b"{a: " * 1_000_000,
     ":1:3999999: not valid YAML: unknown token; check brackets, colons and indentation here and just before, "
     "and put expressions in quotes"),
    ("nested ten million deep", b"[" * 10_000_000,
     ": has more than 4 MiB; a scene is a short text: is this the right file?"),
    ("key of three million letters", b"k" * 3_000_000 + b": 1\n",
     ":1:3000001: not valid YAML: illegal map value; check brackets, colons and indentation here and just "
     "before, and put expressions in quotes"),
]
