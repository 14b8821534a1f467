package lightning.cli;

import static java.util.Objects.requireNonNull;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import lightning.base.text.PrintableText;
import lightning.cli.option.PictureOptions;
import lightning.cli.option.ThreadsOption;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.PictureOutput;
import lightning.cli.output.ProgressBar;
import lightning.cli.output.ViewOption;
import lightning.cli.report.ReviewReport;
import lightning.format.jen.InputFiles;
import lightning.format.jen.JenDocument;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.review.Review;
import lightning.review.ReviewContent;
import lightning.review.ReviewLook;
import lightning.review.ReviewPage;
import lightning.review.ReviewReader;
import lightning.review.ReviewedScene;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Writes a page with a fader for each light, and applies what a reviewer saved in it. */
@Command(name = "review", header = "Write a review page, or apply a review.", abbreviateSynopsis = true,
        description = {
            "Writes one HTML file that shows the picture with a fader, color, solo and mute for each light and light group, an exposure, and notes "
                    + "that are pinned to the picture. It needs no server and no network, only a browser with WebGL 2. The reviewer saves a small "
                    + "JSON file.",
            "",
            "The page offers the looks of the scene and compares two of them. A scene with a shot becomes a filmstrip: all faders apply to all frames.",
            "",
            "With --apply, reads such a file, prints its notes, and writes the scene as the reviewer saw it. Changes of lights that no longer "
                    + "exist are named and left out.",
            "",
            "With --live, prints the address of a live page and runs until you stop it. With --allow-edits, the page's faders move the lights, "
                    + "exact pictures follow, and -o names the scene that each change is saved to."},
        footer = {
            "Examples:",
            "  lightning review scenes/bird.jen -o bird.html --size 480x480",
            "  lightning review scenes/dusk.jen -o dusk.html --frames 1,24,48"})
final class ReviewCommand implements Callable<Integer> {
    private static final String PAGE = ".html";

    private final Console console;

    @Mixin
    private SceneFile input;
    @Option(names = {"-o", "--output"}, paramLabel = "FILE", description = "Page to write, .html; with --apply the scene to write, .jen.")
    private @Nullable Path output;
    @Option(names = "--apply", paramLabel = "review.json", description = "Review to apply to the scene.")
    private @Nullable Path review;
    @Mixin
    private ReviewPageOptions page;
    @Mixin
    private LiveReviewOptions live;
    @Mixin
    private ViewOption view;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;

    ReviewCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        if (output == null && review == null && !live.isOn()) {
            throw new BadInputException("review: expected -o page.html, --apply review.json, or --live");
        }
        live.check(review != null, output != null);
        page.check(review == null && !live.isOn());
        if (review != null && view.isChosen()) {
            throw new BadInputException("review: --view is of a page, not of --apply");
        }
        if (live.isOn() && console.report().isJson()) {
            throw new BadInputException("review: --live does not take --json: it runs until it is stopped");
        }
        if (output != null) {
            PictureOutput.checkFile(output);
            boolean isPage = output.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(PAGE);
            boolean writesPage = review == null && !live.isOn();
            if (isPage != writesPage) {
                throw new BadInputException(writesPage ? Console.text("%s: a review page is written to %s", output, PAGE)
                        : Console.text("%s: with %s, -o is a scene", output, live.isOn() ? "--live" : "--apply"));
            }
        }
        JenDocument document = input.read(console);
        view.printNotes(console);
        if (output != null) {
            view.withFile(InputFiles.of(input.path(), List.of(document.scene()))).check(output);
        }
        if (live.isOn()) {
            new LiveReviewRun(console, input.path().getFileName().toString(), RenderOptions.DEFAULT.withThreads(threads.count()), view)
                    .run(document.withScene(picture.apply(document.scene())), live, output);
        } else if (review == null) {
            writePage(document);
        } else {
            apply(document, review);
        }
        return ExitCode.OK;
    }

    private void writePage(JenDocument document) throws Exception {
        Path file = requireNonNull(output);
        ReviewContent content = page.content(document, input.path(), picture, view, console);
        List<Integer> frames = content.pictures().stream().flatMapToInt(shown -> shown.frame().stream()).boxed().toList();
        List<String> looks = content.pictures().getFirst().looks().stream().map(ReviewLook::name).toList();
        PictureSettings size = content.pictures().getFirst().scene().picture();
        String shown = frames.isEmpty() ? "" : Console.count(frames.size(), "frame") + ", ";
        console.print("%s: %s%d x %d pixels, about %.1f MB", file, shown, size.width(), size.height(), content.estimatedBytes() / 1e6);
        RenderOptions options = RenderOptions.DEFAULT.withThreads(threads.count());
        try (Renderer renderer = new Renderer(options); ProgressBar bar = new ProgressBar(console, "tracing")) {
            ReviewPage.write(file, content, renderer, options, bar);
        }
        console.print("%s: %s%s%s, %d x %d pixels, %.1f MB", file, shown, Console.count(content.lights().size(), "light"),
                looks.isEmpty() ? "" : ", " + Console.count(looks.size(), "look"), size.width(), size.height(), Files.size(file) / 1e6);
        console.report()
                .setResult(new ReviewReport(file.toString(), Files.size(file), content.lightNames(), frames, looks, null, List.of()));
    }

    private void apply(JenDocument document, Path file) throws Exception {
        Review read = ReviewReader.read(file);
        Scene scene = document.scene();
        ReviewedScene reviewed = ReviewedScene.of(scene, read);
        List<ReviewReport.Comment> comments = new ArrayList<>();
        for (Review.Note note : read.notes()) {
            Integer frame = note.frame().isPresent() ? note.frame().getAsInt() : null;
            comments.add(new ReviewReport.Comment(frame, (int) Math.min(note.x() * scene.picture().width(), scene.picture().width() - 1.0),
                    (int) Math.min(note.y() * scene.picture().height(), scene.picture().height() - 1.0), note.text()));
        }
        console.print("%s of %s: %s and %s changed, %s", file.getFileName(),
                read.reviewer().isBlank() ? "an unnamed reviewer" : PrintableText.escape(read.reviewer()),
                Console.count(read.lights().size(), "light"), Console.count(read.groups().size(), "light group"),
                Console.count(comments.size(), "note"));
        comments.forEach(
                note -> console.print("  %s%d,%d: %s", note.frame() == null ? "" : "frame " + note.frame() + ", ", note.x(), note.y(),
                        PrintableText.escape(note.text())));
        reviewed.notes().forEach(note -> console.warn("%s: %s", file, note));
        List<String> lights = read.lights().stream().map(change -> change.light().name(scene)).toList();
        KeyedLightNotes.print(document.shot(), lights, console);
        if (output != null) {
            document.withScene(reviewed.scene()).save(output);
        }
        console.report().setResult(
                new ReviewReport(output == null ? null : output.toString(), null, lights, List.of(), List.of(), read.reviewer(), comments));
    }
}
