package lightning.cli;

import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import lightning.base.text.ReleaseInfo;
import lightning.render.relight.tile.RenderOptions;
import lightning.shot.LocalFrameHost;
import lightning.shot.cluster.HostPort;
import lightning.shot.cluster.NodeConfig;
import lightning.shot.cluster.RenderNode;
import lightning.shot.cluster.SelfSignedCertificate;
import lightning.shot.cluster.TlsNetwork;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Holds frames of shots for other machines. */
@Command(name = "node", abbreviateSynopsis = true, header = "Hold frames of shots for other machines.",
        description = {
            "Takes part in a cluster until it is ended, and holds frames for those who relight a shot with --cluster. Machines of a cluster",
            "share a certificate, a file that --make-certificate makes once and that is brought to each of them: who has it may take",
            "part, and nobody else. The first node of a cluster joins nobody, each other one any that is there. Nodes may come and go at",
            "any time; frames of one that is gone are traced again by others. Without --bind a node is heard on its own machine alone."},
        footer = {
            "Examples:",
            "  lightning node --make-certificate cluster.p12",
            "  lightning node --certificate cluster.p12 --bind 10.0.0.7",
            "  lightning node --certificate cluster.p12 --bind 10.0.0.8 --join 10.0.0.7:7800"})
final class NodeCommand implements Callable<Integer> {
    private static final int MAX_PORT = 65_535;
    private static final double GB = 1e9;

    private final Console console;

    @Spec
    private CommandSpec command;
    @Mixin
    private ClusterMemberOptions member;
    @Mixin
    private ThreadsOption threads;
    @Option(names = "--join", paramLabel = "HOST:PORT", converter = HostPortConverter.class,
            description = "A node that is there, of port " + NodeConfig.NODE_PORT + " where none is said; several where one may be gone.")
    private List<HostPort> join = List.of();
    @Option(names = "--port", paramLabel = "N", defaultValue = "" + NodeConfig.NODE_PORT,
            description = "The port, ${DEFAULT-VALUE} without it.")
    private int port;
    @Option(names = "--memory", paramLabel = "GB",
            description = "How much memory frames may take, half of what Java has without it; more go to disk, and what has no room there to other nodes.")
    private Double memory;
    @Option(names = "--folder", paramLabel = "FOLDER",
            description = "Where the node makes a folder of its own for what comes from others and frames beyond memory; the program's own without it.")
    private Path folder;
    @Option(names = "--make-certificate", paramLabel = "FILE", description = "Makes a key with its certificate, and nothing else.")
    private Path certificateOutput;

    NodeCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        if (certificateOutput != null) {
            SelfSignedCertificate.write(certificateOutput);
            console.print("%s: a new key with its certificate; bring it to each machine of the cluster, and to nobody else",
                    certificateOutput);
            return ExitCode.OK;
        }
        if (port < 1 || port > MAX_PORT) {
            throw new ParameterException(command.commandLine(), "--port must be from 1 to " + MAX_PORT + ", was " + port);
        }
        if (memory != null && !(memory >= 0)) {
            throw new ParameterException(command.commandLine(), "--memory must be 0 or more, was " + memory);
        }
        NodeConfig config = member.nodeConfig("--join", join, port, 1);
        serve(config);
        return ExitCode.OK;
    }

    private void serve(NodeConfig config) throws Exception {
        RenderOptions options = RenderOptions.DEFAULT.withThreads(threads.count());
        long frameMemory = memory == null ? options.memory() / 2 : (long) (memory * GB);
        Path nodeFolder = nodeFolder(config.bind());
        var settings = new RenderNode.Settings(ReleaseInfo.machineText(), threads.count(), frameMemory, nodeFolder,
                () -> LocalFrameHost.createPinned(options, frameMemory / RenderNode.MAX_SESSIONS, nodeFolder,
                        Files.getFileStore(nodeFolder).getUsableSpace() / RenderNode.MAX_SESSIONS),
                sentence -> console.print("%s", sentence));
        try (var node = new RenderNode(new TlsNetwork(config), settings)) {
            node.start();
            console.print("a node at %s; Ctrl-C ends it", config.addressText());
            Thread.sleep(Long.MAX_VALUE);
        } catch (InterruptedException e) {
            throw new CancellationException();
        }
    }

    /** Named by the address too: machines may share a home folder. */
    private Path nodeFolder(InetAddress bind) {
        String data = System.getProperty("lightning.data");
        Path parent = folder != null ? folder : data != null ? Path.of(data) : Path.of(System.getProperty("user.home"), ".lightning");
        return parent.resolve("lightning-node-" + bind.getHostAddress().replaceAll("[^0-9A-Za-z.]", "_") + "-" + port);
    }
}
