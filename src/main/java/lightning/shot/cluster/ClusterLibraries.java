package lightning.shot.cluster;

import java.io.ObjectInputFilter;
import lightning.base.text.Messages;

/** Optional libraries for clusters, loaded only by processes that use other machines. */
final class ClusterLibraries {
    private ClusterLibraries() {}

    /**
     * Prepares the process for the libraries: rejects all serialized Java objects from the network.
     *
     * @throws JoinException if the libraries are missing
     */
    static void require() throws JoinException {
        try {
            Class.forName("org.jgroups.JChannel", false, ClusterLibraries.class.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new JoinException(Messages.tr("cluster libraries not found; start Lightning with bin/lightning"), e);
        }
        rejectSerializedObjects();
    }

    /** Keeps a filter with which the process was started. */
    private static synchronized void rejectSerializedObjects() {
        if (ObjectInputFilter.Config.getSerialFilter() == null) {
            ObjectInputFilter.Config.setSerialFilter(ObjectInputFilter.Config.createFilter("!*"));
        }
    }
}
