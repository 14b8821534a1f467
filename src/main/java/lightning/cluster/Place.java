package lightning.cluster;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;

/**
 * Where a process takes part, and with whom.
 *
 * @param bind        the address where it is heard
 * @param port        the first port that it may take
 * @param ports       how many it may try
 * @param join        where members are asked for; none for the first member
 * @param certificate the file that all members have
 * @param timing      when a member counts as lost
 */
public record Place(InetAddress bind, int port, int ports, List<InetSocketAddress> join, Path certificate, Timing timing) {
    /** Of nodes. */
    public static final int NODE_PORT = 7800;
    /** Of those that ask, the first of {@value #ASKING_PORTS}. */
    public static final int ASKING_PORT = 7900;
    public static final int ASKING_PORTS = 100;

    /**
     * When a member counts as lost: one whose connection ended, when it does not answer a question; one that is silent, after so long.
     *
     * @param silence milliseconds without a sign of life
     * @param verify  milliseconds that it has to answer
     * @param merge   milliseconds after which parts of a cluster look for each other, at most
     */
    public record Timing(long silence, long verify, long merge) {
        public static final Timing DEFAULT = new Timing(15_000, 4000, 3000);
    }
}
