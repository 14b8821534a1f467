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
 * Network configuration of a cluster member.
 *
 * @param bind        listening address
 * @param port        first port to try
 * @param ports       number of ports to try
 * @param join        addresses of known members; none for the first member
 * @param certificate file that all members share
 * @param timing      timeouts of membership
 */
public record NodeConfig(InetAddress bind, int port, int ports, List<InetSocketAddress> join, Path certificate, Timing timing) {
    /** Default port of nodes. */
    public static final int NODE_PORT = 7800;
    /** Default first port of clients, of {@value #CLIENT_PORTS}. */
    public static final int CLIENT_PORT = 7900;
    public static final int CLIENT_PORTS = 100;

    /**
     * Creates a configuration and checks that the cluster libraries exist.
     *
     * @throws JoinException if they do not
     */
    public static NodeConfig of(InetAddress bind, int port, int ports, List<InetSocketAddress> join, Path certificate)
            throws JoinException {
        ClusterLibraries.require();
        return new NodeConfig(bind, port, ports, join, certificate, Timing.DEFAULT);
    }

    /**
     * Creates a client's configuration. Listens at this machine's address on the route to the first host; for a local host that is the
     * loopback address. May query a name server and wait for it.
     *
     * @throws JoinException if the host is unknown or has no route
     */
    public static NodeConfig forClient(List<HostPort> hosts, Path certificate) throws JoinException {
        List<InetSocketAddress> join = new ArrayList<>();
        for (HostPort host : hosts) {
            join.add(host.address());
        }
        return of(localAddressFor(join.getFirst()), CLIENT_PORT, CLIENT_PORTS, join, certificate);
    }

    /** Returns the listening address and port as a user would type them. */
    public String addressText() {
        return new HostPort(bind.getHostAddress(), port).format();
    }

    /** Returns the first address to join as a user would type it. */
    public String firstJoinText() {
        return new HostPort(join.getFirst().getHostString(), join.getFirst().getPort()).format();
    }

    private static InetAddress localAddressFor(InetSocketAddress remote) throws JoinException {
        if (remote.getAddress().isLoopbackAddress()) {
            return InetAddress.getLoopbackAddress();
        }
        // Sends nothing: connecting only selects the local address.
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
     * Timeouts of membership. A closed connection or silence makes a member suspect; it is lost if it does not answer a check.
     *
     * @param join    milliseconds of looking for others before starting a new cluster
     * @param silence milliseconds without a heartbeat before a member is suspect
     * @param verify  milliseconds for the answer to a check
     * @param merge   maximum milliseconds between searches for other parts of the cluster
     */
    public record Timing(long join, long silence, long verify, long merge) {
        public static final Timing DEFAULT = new Timing(2000, 15_000, 4000, 1500);
    }
}
