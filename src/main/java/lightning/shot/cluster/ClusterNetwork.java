package lightning.shot.cluster;

import java.util.Set;

/**
 * Message transport between members of a cluster. Messages arrive complete, once and in order as long as both are members; messages in
 * flight may be lost with a member.
 */
public interface ClusterNetwork extends AutoCloseable {
    /** Listener for network events, called on one thread. */
    interface Listener {
        /** @param bytes owned by the listener */
        void messageReceived(ClusterMember from, byte[] bytes);

        /** @param others all members except this one */
        void membersChanged(Set<ClusterMember> others);
    }

    /** Joins the cluster; called once. */
    void join(Listener listener) throws JoinException;

    /** Sends to a member; ignored if it left. May block if the receiver is slow. */
    void send(ClusterMember to, byte[] bytes);

    /** Leaves and joins again as a new member, if expected members do not appear. May take seconds. */
    void rejoin();

    /** Returns a member's host and port for the user. */
    String addressOf(ClusterMember member);

    /** Leaves the cluster. */
    @Override
    void close();
}
