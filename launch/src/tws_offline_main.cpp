#include "offline_main.h"

int main(int argc, char** argv) { return tws_launch::offlineMain(argc, argv, tws_launch::nodeRegistry()); }
