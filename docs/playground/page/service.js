const VERSION_ = "VERSION";
const FILES_ = "FILES";
