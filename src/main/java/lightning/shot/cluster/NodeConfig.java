package lightning.shot.cluster;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Messages;

/**
 * Where a process takes part, and with whom.
 *
 * @param bind        the address where it is heard
 * @param port        the first port that it may take
 * @param ports       how many it may try
 * @param join        where members are asked for; none for the first member
 * @param certificate the file that all members have
 * @param timing      when a member counts as the first, and when as lost
 */
public record NodeConfig(InetAddress bind, int port, int ports, List<InetSocketAddress> join, Path certificate, Timing timing) {
    /** Of nodes. */
    public static final int NODE_PORT = 7800;
    /** Of those that ask, the first of {@value #CLIENT_PORTS}. */
    public static final int CLIENT_PORT = 7900;
    public static final int CLIENT_PORTS = 100;

    /**
     * Where a process takes part, with the libraries for that at hand.
     *
     * @throws JoinException if they are not
     */
    public static NodeConfig of(InetAddress bind, int port, int ports, List<InetSocketAddress> join, Path certificate)
            throws JoinException {
        ClusterLibraries.require();
        return new NodeConfig(bind, port, ports, join, certificate, Timing.DEFAULT);
    }

    /**
     * Where a process takes part that asks others to hold frames: at the address of this machine from which the first of them is reached, which
     * on the machine itself is one that no other reaches. May ask a name server, and wait for it.
     *
     * @throws JoinException if there is no such machine, or no way to it
     */
    public static NodeConfig forClient(List<HostPort> hosts, Path certificate) throws JoinException {
        List<InetSocketAddress> join = new ArrayList<>();
        for (HostPort host : hosts) {
            join.add(host.address());
        }
        return of(localAddressFor(join.getFirst()), CLIENT_PORT, CLIENT_PORTS, join, certificate);
    }

    /** Returns the address and port at which this process listens, as a person would type them. */
    public String addressText() {
        return new HostPort(bind.getHostAddress(), port).format();
    }

    /** Returns the first member that is asked for, as a person would type it. */
    public String firstJoinText() {
        return new HostPort(join.getFirst().getHostString(), join.getFirst().getPort()).format();
    }

    private static InetAddress localAddressFor(InetSocketAddress remote) throws JoinException {
        if (remote.getAddress().isLoopbackAddress()) {
            return InetAddress.getLoopbackAddress();
        }
        // Nothing is sent: the system only says which of its addresses would be.
        try (var socket = new DatagramSocket()) {
            socket.connect(remote);
            if (!socket.getLocalAddress().isAnyLocalAddress()) {
                return socket.getLocalAddress();
            }
        } catch (IOException | UncheckedIOException e) {
            throw new JoinException(Messages.tr("no network route to {0}: {1}", remote.getHostString(), e.getMessage()),
                    e);
        }
        throw new JoinException(Messages.tr("no network route to {0}", remote.getHostString()), null);
    }

    /**
     * When a member counts as the first, and when as lost: one whose connection ended, when it does not answer a question; one that is
     * silent, after so long.
     *
     * @param join    milliseconds in which a member looks for others before it counts as the first
     * @param silence milliseconds without a sign of life
     * @param verify  milliseconds that it has to answer
     * @param merge   milliseconds after which parts of a cluster look for each other, at most
     */
    public record Timing(long join, long silence, long verify, long merge) {
        public static final Timing DEFAULT = new Timing(2000, 15_000, 4000, 1500);
    }
}
