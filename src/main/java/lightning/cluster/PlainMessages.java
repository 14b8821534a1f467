package lightning.cluster;

import org.jgroups.Message;
import org.jgroups.MessageFactory;

/** Which messages JGroups reads: bytes, and none. The others would make objects of classes that a message names. */
final class PlainMessages extends MessageFactory {
    private PlainMessages() {}

    /** For this process, from here on. */
    static synchronized void alone() {
        for (int type = 0; type < creators.length; type++) {
            if (type != Message.BYTES_MSG && type != Message.EMPTY_MSG) {
                creators[type] = null;
            }
        }
    }
}
