package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.bench.accuracy.WarmSaving;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenFile;
import lightning.render.cache.PixelCache;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.Options;
import lightning.render.warmup.LateWarmUp;
import lightning.scene.Scene;
import lightning.scene.shot.Key;
import lightning.scene.shot.Shot;
import lightning.scene.shot.ShotSuccession;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;
import lightning.shot.KeptBytes;
import lightning.shot.LocalKeeper;
import lightning.shot.RelitShot;
import lightning.shot.ShotNeed;
import lightning.shot.ShotTooLarge;
import lightning.shot.Take;
import lightning.shot.cluster.Place;
import lightning.shot.movie.FrameFiles;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Traces all frames of a shot, keeps what each was made of, and makes edits in all of them. */
@Command(name = "relight", abbreviateSynopsis = true, header = "Edit lights and materials in all frames of a shot.",
        description = {
            "Traces every frame once and keeps what that found, in memory and, where that is full, in files that are removed in the",
            "end. Then the edits are made in all frames, and only what they change is computed anew; each picture is that of its",
            "frame's scene in every bit. Edits up to a --then (or the end) are made at once. Without a --then pictures are named",
            "as by 'shot render'; with some, those of the first group go into a folder 1 where these would be, of the second into",
            "2, and so on: several lightings are tried in one go. --set refuses what has keys in the shot, and tells the keys. At",
            "the end stands what the last group saves of tracing its frames in full, measured as by 'relight' with some of them;",
            "--no-savings leaves that out. With --cluster, nodes on other machines hold the frames; --memory, --disk and",
            "--no-savings are then not used.",
            "",
            "A picture appears whole or not at all; those that are finished stay when the command is cancelled."},
        footer = {
            "Examples:",
            "  lightning shot relight scenes/dusk.jen --frames 1-24 --set world.ambience=0.5 -o dim",
            "  lightning shot relight scenes/dusk.jen --frames 1-24 --delete sky --then --set \"left light.attenuation=1 0 0\" -o tries"})
final class ShotRelightCommand implements Callable<Integer> {
    private static final double GB = 1e9;
    /** Frames that tell the saving, as many of them as are measured in so long. */
    private static final int MEASURED = 3;
    private static final long LONG_NANOSECONDS = 5_000_000_000L;

    private final Console console;

    @Mixin
    private SceneFile input;
    @Mixin
    private FramesOutput output;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;
    @Mixin
    private ClusterOption cluster;
    @ArgGroup(exclusive = true, multiplicity = "1..*", heading = "Edits:%n")
    private List<EditStep> steps;
    @Mixin
    private FramesOption frames;
    @Option(names = "--memory", paramLabel = "GB",
            description = "How much memory frames may take while nobody works on them; as much as Java has without it.")
    private Double memory;
    @Option(names = "--disk", paramLabel = "FOLDER",
            description = "Where frames are kept that find no room in memory; the system's folder for temporary files without it.")
    private Path disk = Path.of(System.getProperty("java.io.tmpdir"));
    @Option(names = "--no-savings",
            description = "Leaves out what relighting saves of a full trace, which takes a second or more to measure.")
    private boolean noSavings;

    ShotRelightCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        FrameFiles files = FrameFiles.of(output.file(), JenFile.stem(input.path().getFileName().toString()));
        output.checkKind(files.file(0));
        if (memory != null && !(memory >= 0)) {
            throw new BadInput("--memory must be 0 or more, was " + memory);
        }
        JenDocument document = input.read();
        ShotFrames shot = frames.of(document, input.path());
        Take first = new Take(picture.apply(document.scene()), shot.shot());
        shot.check(first.scene());
        List<Take> edited = edited(document.scene(), shot.shot());
        for (Take take : edited) {
            new ShotFrames(take.shot(), shot.range()).check(take.scene());
        }
        Optional<Place> place = cluster.place();
        // Here there must be room before a folder is made; nodes have their own.
        Optional<Room> room = place.isPresent() ? Optional.empty() : Optional.of(room(first, shot.range(), files));
        List<FrameFiles> groups = groups(files, edited.size());
        for (FrameFiles group : groups) {
            for (int frame = shot.range().first(); frame <= shot.range().last(); frame++) {
                PictureOutput.checkFile(group.file(frame));
            }
        }
        if (place.isPresent()) {
            new RelightElsewhere(console, output, place.get(), input.path().toAbsolutePath().getParent(), threads.count())
                    .run(first, edited, groups, shot.range());
        } else {
            relight(first, edited, groups, shot.range(), room.orElseThrow());
        }
        return ExitCode.DONE;
    }

    /**
     * Where frames are kept.
     *
     * @param memory bytes for those that nobody works on; likewise {@code disk}
     */
    private record Room(Options options, ShotNeed need, long memory, long disk) {}

    private Room room(Take first, FrameRange range, FrameFiles files) throws IOException, BadInput {
        Options options = Options.DEFAULT.withThreads(threads.count())
                .withMemory(PictureOutput.memory(first.scene(), files.file(0)));
        if (!Files.isDirectory(disk)) {
            throw new BadInput(Console.text("--disk %s: is no folder", disk));
        }
        ShotNeed need = ShotNeed.of(first, range.first(), range.last(), options);
        long most = need.inMemory(options.memory());
        Room room = new Room(options, need, memory == null ? most : Math.min(most, (long) (memory * GB)),
                Files.getFileStore(disk).getUsableSpace());
        try {
            need.check(room.memory, room.disk);
        } catch (ShotTooLarge e) {
            throw new BadInput(e.getMessage() + "; or give a folder on a larger disk with --disk FOLDER");
        }
        return room;
    }

    /** Where the pictures of each group go; their folders are made. */
    private static List<FrameFiles> groups(FrameFiles files, int count) throws IOException {
        files.makeFolder();
        if (count == 1) {
            return List.of(files);
        }
        List<FrameFiles> groups = new ArrayList<>();
        for (int group = 1; group <= count; group++) {
            groups.add(new FrameFiles(files.folder().resolve(String.valueOf(group)), files.name(), files.ending()));
            groups.getLast().makeFolder();
        }
        return groups;
    }

    private void relight(Take first, List<Take> edited, List<FrameFiles> groups, FrameRange range, Room room) throws Exception {
        ShotNeed need = room.need;
        boolean fits = need.all() <= room.memory;
        console.line("%s of about %s: %s in all, %s in memory, %s on disk", Console.count(need.frames(), "frame"),
                ShotNeed.text(need.each()),
                ShotNeed.text(need.all()), ShotNeed.text(Math.min(room.memory, need.all())),
                ShotNeed.text(Math.max(0, need.all() - room.memory)));
        LocalKeeper keeper =
                fits ? new LocalKeeper(room.options, room.memory) : new LocalKeeper(room.options, room.memory, disk, room.disk);
        var watch = new ShotWatch(range.count());
        KeptBytes kept;
        try (var _ = new LateWarmUp(first.at(range.first()));
                RelitShot shot = RelitShot.of(range.first(), range.last(), keeper, watch)) {
            watch.run(shot, first, console, "tracing", null);
            console.line("%s traced in %.1f ms", Console.count(range.count(), "frame"), watch.work());
            kept = shot.bytes();
            console.line("kept: %s, %s, in memory, and %d, %s, on disk", Console.count(kept.inMemory(), "frame"),
                    ShotNeed.text(kept.memory()),
                    kept.onDisk(),
                    ShotNeed.text(kept.disk()));
            keeper.problem().ifPresent(problem -> console.line("%s traced again for each edit: %s",
                    Console.count(range.count() - kept.inMemory() - kept.onDisk(), "frame"), problem));
            for (int group = 0; group < edited.size(); group++) {
                FrameFiles files = groups.get(group);
                double whole;
                try (var writing = new PictureWriting(threads.count())) {
                    whole = watch.run(shot, edited.get(group), console, "relighting", update -> {
                        if (writing.failed()) {
                            throw new CancellationException();
                        }
                        writing.write(() -> output.write(update.film(), files.file(update.frame())));
                    });
                    writing.finish();
                }
                console.line("%d. %s: %s relit in %.1f ms, %d of them traced again, %s; %.1f ms with their pictures", group + 1,
                        files.folder(), Console.count(range.count(), "frame"), watch.work(), watch.traced(),
                        Console.count(watch.rays(), "ray"), whole);
            }
        }
        if (!noSavings) {
            tellSaving(edited.size() == 1 ? first : edited.get(edited.size() - 2), edited.getLast(), range, room, kept);
        }
    }

    /** What a take saves of tracing its frames, each as for a single picture: some of them, where one does not take long. */
    private void tellSaving(Take before, Take after, FrameRange range, Room room, KeptBytes kept) {
        List<WarmSaving> savings = new ArrayList<>();
        int count = Math.min(MEASURED, range.count());
        try (Workers workers = new Workers(threads.count()); ProgressBar bar = new ProgressBar(console, "measuring what that saves")) {
            long start = System.nanoTime();
            for (int i = 0; i < count && (i == 0 || System.nanoTime() - start < LONG_NANOSECONDS); i++) {
                int frame = count == 1 ? range.first() : range.first() + (int) ((long) (range.count() - 1) * i / (count - 1));
                saving(before.at(frame), after.at(frame), room.options, workers, bar.silent()).ifPresent(savings::add);
                bar.tiles(i + 1, count);
            }
        }
        double update = savings.stream().mapToDouble(s -> s.update().median()).sum();
        double full = savings.stream().mapToDouble(s -> s.full().median()).sum();
        if (!savings.isEmpty()) {
            console.line("once Java is warm, a frame takes %.1f ms of a full trace's %.1f (saves %.1f %%)%s", update / savings.size(),
                    full / savings.size(), 100 * (1 - update / full), kept.onDisk() == 0 ? "" : ", and those on disk are read besides");
        }
    }

    private static Optional<WarmSaving> saving(Scene before, Scene after, Options options, Workers workers, Progress progress) {
        try (Renderer renderer = new Renderer(options)) {
            renderer.render(before, progress);
            PixelCache start = renderer.cache();
            WarmSaving.Step step = (r, p) -> r.render(after, p);
            return WarmSaving.Edit.of(step.on(renderer, progress), start, options, step)
                    .flatMap(edit -> WarmSaving.measure(edit, workers, RelightCommand.WARM_UP_MS, progress));
        }
    }

    /** The take after each group of edits. */
    private List<Take> edited(Scene scene, Shot keys) throws BadInput {
        List<Take> takes = new ArrayList<>();
        Scene current = scene;
        Shot shot = keys;
        for (List<EditStep> group : EditStep.groups(steps)) {
            for (EditStep step : group) {
                List<Scene> next = step.apply(current, input.path().toAbsolutePath().getParent());
                for (int i = 0; i < next.size(); i++) {
                    refuseKeyed(shot, current, next.get(i));
                    shot = new ShotSuccession(current, next.get(i)).of(shot);
                    current = next.get(i);
                    if (i < next.size() - 1) {
                        takes.add(new Take(picture.apply(current), shot));
                    }
                }
            }
            EditStep.remarkUnused(group, current, console);
            takes.add(new Take(picture.apply(current), shot));
        }
        return takes;
    }

    /** Keys would hide what is set. */
    private static void refuseKeyed(Shot shot, Scene before, Scene after) throws BadInput {
        for (Track track : shot.tracks()) {
            Target target = track.target();
            boolean stays = target.isIn(before) && target.isIn(after) && target.attribute(after, track.attribute()).isPresent();
            if (stays && !target.setting(after, track.attribute()).equals(target.setting(before, track.attribute()))) {
                List<Integer> keys = track.keys().stream().map(Key::frame).toList();
                throw new BadInput(Console.text(
                        "%s: %s has keys at frame%s %s, which say what it is; edit these in the shot block, or set what has no keys%s",
                        target, track.attribute(), keys.size() == 1 ? "" : "s", several(keys),
                        track.attribute().equals("intensity") ? ", as the intensity of a bank" : ""));
            }
        }
    }

    private static String several(List<Integer> frames) {
        List<String> texts = frames.stream().limit(8).map(String::valueOf).toList();
        return String.join(", ", texts) + (frames.size() > texts.size() ? " and " + (frames.size() - texts.size()) + " more" : "");
    }
}
