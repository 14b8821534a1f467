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
import lightning.shot.cluster.Place;
import picocli.CommandLine.Option;

/** How a process takes part in a cluster. */
final class MemberOptions {
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
     * @param others who is asked first
     * @throws BadInput      if nobody could be reached so
     * @throws JoinException if a place or the certificate cannot be used
     */
    Place place(String option, List<HostPort> others, int port, int ports) throws BadInput, JoinException {
        if (certificate == null) {
            throw new BadInput("--certificate FILE is missing: the file that all machines of the cluster have; "
                    + "'lightning node --make-certificate FILE' makes one");
        }
        InetAddress own = bind == null ? InetAddress.getLoopbackAddress() : HostPort.address(bind);
        if (own.isAnyLocalAddress()) {
            throw new BadInput("--bind must be one address of this machine, was " + bind);
        }
        if (!isOfThisMachine(own)) {
            throw new BadInput("--bind must be an address of this machine, was " + bind + ", which no network interface has");
        }
        List<InetSocketAddress> join = new ArrayList<>();
        for (HostPort other : others) {
            InetSocketAddress address = other.address();
            if (own.isLoopbackAddress() && !address.getAddress().isLoopbackAddress()) {
                throw new BadInput(option + " " + other.host() + " is another machine, and this one can be reached by none: "
                        + "state --bind ADDRESS, an address of this machine that others reach");
            }
            join.add(address);
        }
        return Place.of(own, port, ports, join, certificate);
    }

    private static boolean isOfThisMachine(InetAddress address) {
        try {
            return address.isLoopbackAddress() || NetworkInterface.getByInetAddress(address) != null;
        } catch (SocketException e) {
            // Binding to it tells.
            return true;
        }
    }
}
