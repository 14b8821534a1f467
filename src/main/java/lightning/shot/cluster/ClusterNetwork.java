package lightning.shot.cluster;

import java.util.Set;

/**
 * Members that send bytes to each other. What is sent arrives whole, once and in order as long as both are members; when one is lost, what was
 * on its way may be.
 */
public interface ClusterNetwork extends AutoCloseable {
    /** Hears of a network, on one thread, one call after the other. */
    interface Listener {
        /** @param bytes not to be written to by anybody else */
        void messageReceived(ClusterMember from, byte[] bytes);

        /** @param others all members but this one */
        void membersChanged(Set<ClusterMember> others);
    }

    /** Takes part from here on; called once. */
    void join(Listener listener) throws JoinException;

    /** Sends to a member; to one that is there no more, nothing. May wait where the other takes its time. */
    void send(ClusterMember to, byte[] bytes);

    /** Leaves and takes part again, as another member: for one who sees nobody though somebody should be there. May take seconds. */
    void rejoin();

    /** What people call a member: host and port. */
    String addressOf(ClusterMember member);

    /** Leaves. */
    @Override
    void close();
}
