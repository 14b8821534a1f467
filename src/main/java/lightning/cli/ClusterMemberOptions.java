package lightning.cli;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.shot.cluster.HostPort;
import lightning.shot.cluster.JoinException;
import lightning.shot.cluster.NodeConfig;
import picocli.CommandLine.Option;

/** How a process takes part in a cluster. */
final class ClusterMemberOptions {
    @Option(names = "--certificate", paramLabel = "FILE",
            description = "The file that all machines of the cluster have, as 'lightning node --make-certificate' makes it.")
    private Path certificate;
    @Option(names = "--bind", paramLabel = "ADDRESS",
            description = "The address of this machine where others reach it; none but this machine can without it.")
    private String bind;

    /**
     * Where the process takes part.
     *
     * @param option what names the others, for messages
     * @param peers who is asked first
     * @throws BadInputException      if nobody could be reached so
     * @throws JoinException if a place or the certificate cannot be used
     */
    NodeConfig nodeConfig(String option, List<HostPort> peers, int port, int ports) throws BadInputException, JoinException {
        if (certificate == null) {
            throw new BadInputException("--certificate FILE is missing: the file that all machines of the cluster have; "
                    + "'lightning node --make-certificate FILE' makes one");
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
                throw new BadInputException(option + " " + peer.host() + " is another machine, and this one can be reached by none: "
                        + "state --bind ADDRESS, an address of this machine that others reach");
            }
            join.add(address);
        }
        return NodeConfig.of(bindAddress, port, ports, join, certificate);
    }

    private static boolean isLocalAddress(InetAddress address) {
        try {
            return address.isLoopbackAddress() || NetworkInterface.getByInetAddress(address) != null;
        } catch (SocketException e) {
            // Binding to it tells.
            return true;
        }
    }
}
