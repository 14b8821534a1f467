package lightning.cli.option;

import java.util.List;
import java.util.Optional;
import lightning.cli.output.BadInputException;
import lightning.shot.cluster.HostPort;
import lightning.shot.cluster.JoinException;
import lightning.shot.cluster.NodeConfig;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Option {@code --cluster} with its own options. */
public final class ClusterOption {
    @Mixin
    private ClusterMemberOptions member;
    @Option(names = "--cluster", paramLabel = "HOST:PORT", converter = HostPortConverter.class,
            description = "Use the nodes of a cluster; name any of them (see 'lightning node --help').")
    private @Nullable HostPort cluster;

    /** Returns the cluster configuration, or empty to render on this machine only. */
    public Optional<NodeConfig> nodeConfig() throws BadInputException, JoinException {
        return cluster == null ? Optional.empty()
                : Optional.of(member.nodeConfig("--cluster", List.of(cluster), NodeConfig.CLIENT_PORT, NodeConfig.CLIENT_PORTS));
    }
}
