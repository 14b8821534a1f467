package lightning.cli.option;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.cli.output.BadInputException;
import lightning.shot.cluster.HostPort;
import lightning.shot.cluster.JoinException;
import lightning.shot.cluster.NodeConfig;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Options of a process that is a member of a cluster. */
public final class ClusterMemberOptions {
    @Option(names = "--certificate", paramLabel = "FILE",
            description = "Certificate file shared by all machines of the cluster (created with 'lightning node --make-certificate').")
    private @Nullable Path certificate;
    @Option(names = "--bind", paramLabel = "ADDRESS",
            description = "Address of this machine at which others reach it (default: localhost only).")
    private @Nullable String bind;

    /**
     * Returns the configuration of this process as a member of the cluster.
     *
     * @param option name of the option that names other members, for messages
     * @param peers members to contact first
     * @param ports number of ports to try
     * @throws BadInputException if this configuration cannot be reached by any member
     * @throws JoinException if an address or the certificate cannot be used
     */
    public NodeConfig nodeConfig(String option, List<HostPort> peers, int port, int ports) throws BadInputException, JoinException {
        if (certificate == null) {
            throw new BadInputException("--certificate FILE is missing: the file shared by all machines of the cluster; "
                    + "'lightning node --make-certificate FILE' creates one");
        }
        InetAddress bindAddress = bind == null ? InetAddress.getLoopbackAddress() : HostPort.address(bind);
        if (bindAddress.isAnyLocalAddress()) {
            throw new BadInputException("--bind must be one address of this machine, was " + bind);
        }
        if (!isLocalAddress(bindAddress)) {
            throw new BadInputException("--bind must be an address of this machine, was " + bind + ", which no network interface has");
        }
        List<InetSocketAddress> join = new ArrayList<>();
        for (HostPort peer : peers) {
            InetSocketAddress address = peer.address();
            if (bindAddress.isLoopbackAddress() && !address.getAddress().isLoopbackAddress()) {
                throw new BadInputException(option + " " + peer.host() + " is another machine, but this machine is not reachable from it: "
                        + "add --bind ADDRESS, an address of this machine that others can reach");
            }
            join.add(address);
        }
        return NodeConfig.of(bindAddress, port, ports, join, certificate);
    }

    private static boolean isLocalAddress(InetAddress address) {
        try {
            return address.isLoopbackAddress() || NetworkInterface.getByInetAddress(address) != null;
        } catch (SocketException e) {
            // Binding a socket shows whether the address belongs to this machine.
            return true;
        }
    }
}
