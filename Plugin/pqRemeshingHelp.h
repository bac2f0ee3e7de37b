#ifndef pqRemeshingHelp_h
#define pqRemeshingHelp_h

/**
 * Gives the plugin's help pages to ParaView's window when that has the plugin: the "?" button of
 * the panel looks for them there. (ParaView's own way, `XML_DOCUMENTATION`, is not there for Qt 6.)
 */
class pqRemeshingHelp
{
public:
  void startup();
  void shutdown() {}
};

#endif
