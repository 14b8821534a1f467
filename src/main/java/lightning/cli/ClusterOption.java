package lightning.cli;

import java.util.List;
import java.util.Optional;
import lightning.shot.cluster.HostPort;
import lightning.shot.cluster.JoinException;
import lightning.shot.cluster.NodeConfig;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The option {@code --cluster}, with what it takes. */
final class ClusterOption {
    @Mixin
    private ClusterMemberOptions member;
    @Option(names = "--cluster", paramLabel = "HOST:PORT", converter = HostPortConverter.class,
            description = "Lets the nodes of a cluster hold the frames; any of them is named. 'lightning node --help' tells more.")
    private HostPort cluster;

    /** Where this process takes part; empty where all is done here. */
    Optional<NodeConfig> nodeConfig() throws BadInputException, JoinException {
        return cluster == null ? Optional.empty()
                : Optional.of(member.nodeConfig("--cluster", List.of(cluster), NodeConfig.CLIENT_PORT, NodeConfig.CLIENT_PORTS));
    }
}
