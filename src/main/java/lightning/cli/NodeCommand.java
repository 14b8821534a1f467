package lightning.cli;

import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import lightning.base.text.ReleaseInfo;
import lightning.cli.option.ClusterMemberOptions;
import lightning.cli.option.HostPortConverter;
import lightning.cli.option.OptionRange;
import lightning.cli.option.ThreadsOption;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.render.RenderOptions;
import lightning.shot.LocalFrameHost;
import lightning.shot.cluster.HostPort;
import lightning.shot.cluster.NodeConfig;
import lightning.shot.cluster.RenderNode;
import lightning.shot.cluster.SelfSignedCertificate;
import lightning.shot.cluster.TlsNetwork;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Runs a render node of a cluster. */
@Command(name = "node", abbreviateSynopsis = true, header = "Run a render node of a cluster.",
        description = {
            "Runs until stopped. Renders and caches frames for machines that relight a shot with --cluster. All machines of a cluster "
                    + "share one certificate file. Create it once with --make-certificate and copy it to each machine; anyone with it "
                    + "can join.",
            "",
            "Start the first node without --join and each further one with the address of any running node. Nodes can join and leave "
                    + "at any time; other nodes re-render the frames of a lost one. Without --bind a node is reachable only from its "
                    + "own machine."},
        footer = {
            "Examples:",
            "  lightning node --make-certificate cluster.p12",
            "  lightning node --certificate cluster.p12 --bind 10.0.0.7",
            "  lightning node --certificate cluster.p12 --bind 10.0.0.8 --join 10.0.0.7"})
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
            description = "Address of a running node (default port: " + NodeConfig.NODE_PORT + "). Repeat to name alternatives.")
    private List<HostPort> join = List.of();
    @Option(names = "--port", paramLabel = "N", defaultValue = "" + NodeConfig.NODE_PORT,
            description = "Port (default: ${DEFAULT-VALUE}).")
    private int port;
    @Option(names = "--memory", paramLabel = "GB",
            description = "Memory for frames in GB (default: half of Java's memory). Further frames go to disk, then to other nodes.")
    private @Nullable Double memory;
    @Option(names = "--folder", paramLabel = "FOLDER",
            description = "Folder for received files and for frames that exceed the memory (default: the program's data folder).")
    private @Nullable Path folder;
    @Option(names = "--make-certificate", paramLabel = "FILE", description = "Create a key and certificate file, then exit.")
    private @Nullable Path certificateOutput;

    NodeCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        if (certificateOutput != null) {
            SelfSignedCertificate.write(certificateOutput);
            console.print("%s: created; copy it to each machine of the cluster and keep it secret: anyone with it can join",
                    certificateOutput);
            return ExitCode.OK;
        }
        OptionRange.check(command, "--port", port, 1, MAX_PORT);
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
            console.print("node running at %s; press Ctrl-C to stop it", config.addressText());
            Thread.sleep(Long.MAX_VALUE);
        } catch (InterruptedException e) {
            throw new CancellationException();
        }
    }

    /** Returns the node's folder; its name contains the address because machines may share a home folder. */
    private Path nodeFolder(InetAddress bind) {
        String data = System.getProperty("lightning.data");
        Path parent = folder != null ? folder : data != null ? Path.of(data) : Path.of(System.getProperty("user.home"), ".lightning");
        return parent.resolve("lightning-node-" + bind.getHostAddress().replaceAll("[^0-9A-Za-z.]", "_") + "-" + port);
    }
}
