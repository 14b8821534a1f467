package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import lightning.base.file.ParentFolder;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.cli.option.ClusterOption;
import lightning.cli.option.FrameRange;
import lightning.cli.option.FramesOption;
import lightning.cli.option.PictureOptions;
import lightning.cli.option.ResidentOption;
import lightning.cli.option.ShotFrames;
import lightning.cli.option.ThreadsOption;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.FrameSequenceOutput;
import lightning.cli.output.PictureOutput;
import lightning.cli.output.PictureWriteQueue;
import lightning.cli.output.ProgressBar;
import lightning.cli.output.ShotProgress;
import lightning.cli.report.ShotRelightReport;
import lightning.format.jen.InputFiles;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenFile;
import lightning.layer.FrameTime;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.Renderer;
import lightning.render.warmup.DelayedLanes;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import lightning.scene.shot.TrackRetargeting;
import lightning.shot.CacheUsage;
import lightning.shot.LocalFrameHost;
import lightning.shot.ShotMemoryEstimate;
import lightning.shot.ShotRelighter;
import lightning.shot.ShotRevision;
import lightning.shot.ShotTooLargeException;
import lightning.shot.cluster.NodeConfig;
import lightning.shot.movie.FrameFiles;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Traces all frames of a shot, caches them, and applies edits to all of them. */
@Command(name = "relight", abbreviateSynopsis = true, header = "Edit lights and materials in all frames of a shot.",
        description = {
            "Traces every frame once and caches it in memory or, if that is full, in temporary files. Then applies the edits to all "
                    + "frames and recomputes only what they change; each image is bit-identical to a full trace.",
            "",
            "The edits up to a --then (or the end) form a group that is rendered as one. With --then, the images of the first group "
                    + "go to a subfolder 1, those of the second to 2, and so on, to compare several lightings. --set rejects properties "
                    + "that are animated in the shot, and lists their keyframes.",
            "",
            "At the end, measures the time saved by the last group on some frames, as relight does (--no-savings skips this). With "
                    + "--cluster, nodes on other machines cache the frames; --memory, --disk and --no-savings are then not used.",
            "",
            "Image files appear only when complete; finished ones remain if the command is canceled."},
        footer = {
            "Examples:",
            "  lightning shot relight scenes/dusk.jen -o dim --frames 1-24 --set sky.on=no"})
final class ShotRelightCommand implements Callable<Integer> {
    private static final double GB = 1e9;
    /** Number of frames of which the savings are measured. */
    private static final int MEASURED_FRAMES = 3;
    private static final long MAX_MEASURE_NANOSECONDS = 5_000_000_000L;

    private final Console console;

    @Mixin
    private SceneFile input;
    @Mixin
    private FrameSequenceOutput output;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;
    @Mixin
    private ResidentOption resident;
    @Mixin
    private ClusterOption cluster;
    @ArgGroup(exclusive = true, multiplicity = "1..*", heading = "%nEdits:%n")
    private List<EditStep> steps;
    @Mixin
    private FramesOption frames;
    @Option(names = "--memory", paramLabel = "GB",
            description = "Memory for cached frames in GB (default: all of Java's memory).")
    private @Nullable Double memory;
    @Option(names = "--disk", paramLabel = "FOLDER",
            description = "Folder for frames that exceed the memory (default: the system's temporary folder).")
    private Path disk = Path.of(System.getProperty("java.io.tmpdir"));
    @Option(names = "--no-savings",
            description = "Skip measuring the time saved, which takes a second or more.")
    private boolean skipsSavings;

    private final List<ShotRelightReport.Group> reports = new ArrayList<>();

    ShotRelightCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        FrameFiles files = FrameFiles.of(output.file(), JenFile.stem(input.path().getFileName().toString()));
        output.checkFormat(files.file(0));
        if (memory != null && !(memory >= 0)) {
            throw new BadInputException("--memory must be 0 or more, was " + memory);
        }
        JenDocument document = input.read(console);
        ShotFrames shot = frames.of(document, input.path());
        ShotRevision original = new ShotRevision(picture.apply(document.scene()), shot.shot());
        shot.check(original.scene());
        List<ShotRevision> revisions = revisions(document.scene(), shot.shot());
        for (ShotRevision revision : revisions) {
            new ShotFrames(revision.shot(), shot.range()).check(revision.scene());
        }
        Optional<NodeConfig> config = cluster.nodeConfig();
        // Local caching needs disk space before an output folder is created; nodes check their own.
        Optional<FrameBudget> room = config.isPresent() ? Optional.empty() : Optional.of(frameBudget(original, shot.range(), files));
        List<FrameFiles> groups = groups(files, revisions.size());
        InputFiles inputs = output.withViewFile(InputFiles.of(input.path(),
                Stream.concat(Stream.of(document.scene()), revisions.stream().map(ShotRevision::scene)).toList()));
        output.printViewNotes(console);
        for (FrameFiles group : groups) {
            for (int frame = shot.range().first(); frame <= shot.range().last(); frame++) {
                PictureOutput.checkFile(group.file(frame), inputs);
            }
        }
        if (config.isPresent()) {
            new ClusterRelight(console, output, config.get(), ParentFolder.of(input.path()), threads.count())
                    .run(original, revisions, groups, shot.range());
        } else {
            relight(original, revisions, groups, shot.range(), room.orElseThrow());
        }
        return ExitCode.OK;
    }

    /**
     * Limits for cached frames.
     *
     * @param memoryBytes bytes for idle frames in memory
     * @param diskBytes bytes for idle frames on disk
     */
    private record FrameBudget(RenderOptions options, ShotMemoryEstimate estimate, long memoryBytes, long diskBytes) {}

    private FrameBudget frameBudget(ShotRevision original, FrameRange range, FrameFiles files) throws IOException, BadInputException {
        RenderOptions options = RenderOptions.DEFAULT.withThreads(threads.count())
                .withMemory(PictureOutput.availableMemory(original.scene(), files.file(0)));
        if (!Files.isDirectory(disk)) {
            throw new BadInputException(Console.text("--disk %s: not a folder", disk));
        }
        ShotMemoryEstimate estimate = ShotMemoryEstimate.of(original, range.first(), range.last(), options);
        long maxMemory = estimate.frameBudget(options.memory());
        FrameBudget room = new FrameBudget(options, estimate, memory == null ? maxMemory : Math.min(maxMemory, (long) (memory * GB)),
                Files.getFileStore(disk).getUsableSpace());
        try {
            estimate.check(room.memoryBytes, room.diskBytes);
        } catch (ShotTooLargeException e) {
            throw new BadInputException(e.getMessage() + "; or name a folder on a larger disk with --disk FOLDER");
        }
        return room;
    }

    /** Returns the image files of each group; creates their folders. */
    private static List<FrameFiles> groups(FrameFiles files, int count) throws IOException {
        files.createFolder();
        if (count == 1) {
            return List.of(files);
        }
        List<FrameFiles> groups = new ArrayList<>();
        for (int group = 1; group <= count; group++) {
            groups.add(new FrameFiles(files.folder().resolve(String.valueOf(group)), files.stem(), files.extension()));
            groups.getLast().createFolder();
        }
        return groups;
    }

    private void relight(ShotRevision original, List<ShotRevision> revisions, List<FrameFiles> groups, FrameRange range, FrameBudget room)
            throws Exception {
        ShotMemoryEstimate estimate = room.estimate;
        boolean fits = estimate.totalBytes() <= room.memoryBytes;
        console.print("%s of about %s: %s total, %s in memory, %s on disk", Console.count(estimate.frameCount(), "frame"),
                ShotMemoryEstimate.formatBytes(estimate.bytesPerFrame()),
                ShotMemoryEstimate.formatBytes(estimate.totalBytes()),
                ShotMemoryEstimate.formatBytes(Math.min(room.memoryBytes, estimate.totalBytes())),
                ShotMemoryEstimate.formatBytes(Math.max(0, estimate.totalBytes() - room.memoryBytes)));
        LocalFrameHost host =
                fits ? new LocalFrameHost(room.options, room.memoryBytes)
                        : new LocalFrameHost(room.options, room.memoryBytes, disk, room.diskBytes);
        var progress = new ShotProgress(range.count());
        CacheUsage usage;
        double tracing;
        try (var _ = new DelayedLanes();
                ShotRelighter shot = ShotRelighter.of(range.first(), range.last(), host, progress)) {
            progress.run(shot, original, console, "tracing", null);
            tracing = progress.workMilliseconds();
            console.print("%s traced in %.1f ms", Console.count(range.count(), "frame"), tracing);
            usage = shot.usage();
            console.print("cached: %s, %s, in memory, and %d, %s, on disk", Console.count(usage.memoryFrames(), "frame"),
                    ShotMemoryEstimate.formatBytes(usage.memoryBytes()),
                    usage.diskFrames(),
                    ShotMemoryEstimate.formatBytes(usage.diskBytes()));
            host.problem().ifPresent(problem -> console.print("%s retraced for each edit: %s",
                    Console.count(range.count() - usage.memoryFrames() - usage.diskFrames(), "frame"), problem));
            for (int group = 0; group < revisions.size(); group++) {
                FrameFiles files = groups.get(group);
                ShotRevision revision = revisions.get(group);
                double totalMilliseconds;
                try (var writing = new PictureWriteQueue(threads.count())) {
                    totalMilliseconds = progress.run(shot, revisions.get(group), console, "relighting", update -> {
                        if (writing.hasFailed()) {
                            throw new CancellationException();
                        }
                        int frame = update.frame();
                        writing.write(() -> output.write(revision.sceneAt(frame), update.film(), files.file(frame),
                                Optional.of(new FrameTime(frame, revision.shot().rate()))));
                    });
                    writing.finish();
                }
                console.print("%d. %s: %s relit in %.1f ms, %d of them retraced, %s; %.1f ms including images", group + 1,
                        files.folder(), Console.count(range.count(), "frame"), progress.workMilliseconds(), progress.tracedCount(),
                        Console.count(progress.rayCount(), "ray"), totalMilliseconds);
                reports.add(new ShotRelightReport.Group(group + 1, files.folder().toString(), progress.workMilliseconds(),
                        totalMilliseconds, progress.tracedCount(), progress.rayCount()));
            }
        }
        ShotRevision before = revisions.size() == 1 ? original : revisions.get(revisions.size() - 2);
        List<WarmSaving> savings = skipsSavings ? List.of() : measureSavings(before, revisions.getLast(), range, room);
        double update = savings.stream().mapToDouble(s -> s.update().median()).average().orElse(0);
        double full = savings.stream().mapToDouble(s -> s.full().median()).average().orElse(0);
        double percent = 100 * (1 - update / full);
        if (!savings.isEmpty()) {
            console.print("warmed up, a frame takes %.1f ms instead of a full trace's %.1f ms (saves %.1f %%)%s", update, full, percent,
                    usage.diskFrames() == 0 ? "" : ", plus reading frames from disk");
        }
        console.report().setResult(savings.isEmpty() ? new ShotRelightReport(range.count(), null, tracing, reports, null, null, null)
                : new ShotRelightReport(range.count(), null, tracing, reports, update, full, percent));
    }

    /** Measures the time that a revision saves compared with tracing its frames in full, on some frames in memory. */
    private List<WarmSaving> measureSavings(ShotRevision before, ShotRevision after, FrameRange range, FrameBudget room) {
        List<WarmSaving> savings = new ArrayList<>();
        int count = Math.min(MEASURED_FRAMES, range.count());
        try (WorkerPool workers = new WorkerPool(threads.count());
                ProgressBar bar = new ProgressBar(console, "measuring savings")) {
            long start = System.nanoTime();
            for (int i = 0; i < count && (i == 0 || System.nanoTime() - start < MAX_MEASURE_NANOSECONDS); i++) {
                int frame = count == 1 ? range.first() : range.first() + (int) ((long) (range.count() - 1) * i / (count - 1));
                saving(before.sceneAt(frame), after.sceneAt(frame), room.options, workers, bar.cancellationOnly()).ifPresent(savings::add);
                bar.report(i + 1, count);
            }
        }
        return savings;
    }

    private static Optional<WarmSaving> saving(Scene before, Scene after, RenderOptions options, WorkerPool workers, Progress progress) {
        try (Renderer renderer = new Renderer(options)) {
            renderer.render(before, progress);
            PixelCache start = renderer.cache();
            WarmSaving.UpdateStep step = (r, p) -> r.render(after, p);
            return WarmSaving.RepeatableEdit.of(step.run(renderer, progress), start, options, step)
                    .flatMap(edit -> WarmSaving.measure(edit, workers, RelightCommand.WARM_UP_MS, progress));
        }
    }

    /** Returns the revision after each group of edits. */
    private List<ShotRevision> revisions(Scene scene, Shot keys) throws BadInputException {
        List<ShotRevision> revisions = new ArrayList<>();
        Scene current = scene;
        Shot shot = keys;
        for (List<EditStep> group : EditStep.splitGroups(steps)) {
            for (EditStep step : group) {
                List<Scene> next = step.apply(current, ParentFolder.of(input.path()));
                for (int i = 0; i < next.size(); i++) {
                    rejectKeyed(shot, current, next.get(i));
                    shot = new TrackRetargeting(current, next.get(i)).retarget(shot);
                    current = next.get(i);
                    if (i < next.size() - 1) {
                        revisions.add(new ShotRevision(picture.apply(current), shot));
                    }
                }
            }
            EditStep.warnUnused(group, current, console);
            revisions.add(new ShotRevision(picture.apply(current), shot));
        }
        return revisions;
    }

    /** Rejects edits of animated attributes, whose keyframes would override the edit. */
    private static void rejectKeyed(Shot shot, Scene before, Scene after) throws BadInputException {
        for (Track track : shot.tracks()) {
            SceneElement<?> target = track.target();
            boolean inBoth = target.existsIn(before) && target.existsIn(after) && target.attribute(after, track.attribute()).isPresent();
            if (inBoth && !KeyframeValue.of(after, target, track.attribute()).equals(KeyframeValue.of(before, target, track.attribute()))) {
                List<Integer> keys = track.keys().stream().map(Keyframe::frame).toList();
                throw new BadInputException(Console.text(
                        "%s: %s is animated (keyframes at frame%s %s); edit its keyframes in the shot block, or set another property%s",
                        target.label(), track.attribute(), keys.size() == 1 ? "" : "s", formatFrames(keys),
                        track.attribute().equals("intensity") ? ", such as the intensity of a light group" : ""));
            }
        }
    }

    private static String formatFrames(List<Integer> frames) {
        List<String> texts = frames.stream().limit(8).map(String::valueOf).toList();
        return String.join(", ", texts) + (frames.size() > texts.size() ? " and " + (frames.size() - texts.size()) + " more" : "");
    }
}
