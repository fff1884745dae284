// For passes without a colour target: newer validation layers object to a colour that goes nowhere.
void main() {}
