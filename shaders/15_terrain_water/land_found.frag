// Where ground is: its distance along the view, in metres.
layout(location = 0) out float found;
void main() { found = 1.0 / gl_FragCoord.w; }
