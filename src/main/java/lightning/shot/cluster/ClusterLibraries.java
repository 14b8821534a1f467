package lightning.shot.cluster;

import java.io.ObjectInputFilter;
import lightning.base.text.Messages;

/** The libraries that make a cluster: loaded by who asks for other machines, and by nobody else. */
final class ClusterLibraries {
    private ClusterLibraries() {}

    /**
     * Makes the process ready for them: whatever others send, Java makes no object of it.
     *
     * @throws JoinException if they are not at hand
     */
    static void require() throws JoinException {
        try {
            Class.forName("org.jgroups.JChannel", false, ClusterLibraries.class.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new JoinException(Messages.tr("cluster libraries not found; start Lightning with bin/lightning"), e);
        }
        rejectSerializedObjects();
    }

    /** Where the process was started with such a filter, that one stays. */
    private static synchronized void rejectSerializedObjects() {
        if (ObjectInputFilter.Config.getSerialFilter() == null) {
            ObjectInputFilter.Config.setSerialFilter(ObjectInputFilter.Config.createFilter("!*"));
        }
    }
}
