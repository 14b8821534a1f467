package lightning.shot.cluster;

import java.io.ObjectInputFilter;
import lightning.base.text.Texts;

/** The libraries that make a cluster: loaded by who asks for other machines, and by nobody else. */
final class Libraries {
    private Libraries() {}

    /**
     * Makes the process ready for them: whatever others send, Java makes no object of it.
     *
     * @throws JoinException if they are not at hand
     */
    static void ready() throws JoinException {
        try {
            Class.forName("org.jgroups.JChannel", false, Libraries.class.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new JoinException(Texts.of("the libraries for other machines are not at hand; start with bin/lightning"), e);
        }
        refuseObjects();
    }

    /** Where the process was started with such a filter, that one stays. */
    private static synchronized void refuseObjects() {
        if (ObjectInputFilter.Config.getSerialFilter() == null) {
            ObjectInputFilter.Config.setSerialFilter(ObjectInputFilter.Config.createFilter("!*"));
        }
    }
}
