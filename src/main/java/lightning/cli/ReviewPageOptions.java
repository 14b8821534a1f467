package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import lightning.base.text.Language;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.cli.option.PictureOptions;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ViewOption;
import lightning.document.look.Look;
import lightning.document.look.LookFiles;
import lightning.format.jen.JenDocument;
import lightning.review.ReviewContent;
import lightning.review.ReviewFilm;
import lightning.review.ReviewLooks;
import lightning.review.ReviewPicture;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Options of a written review page: frames, looks and language. */
final class ReviewPageOptions {
    private static final int MAX_FRAMES = 100;
    @Option(names = "--frames", paramLabel = "N", split = ",",
            description = "Frames of the shot that a page shows, separated by commas (default: " + ReviewFilm.FRAMES + ", evenly spaced).")
    private List<Integer> frames = List.of();
    @Option(names = "--look", paramLabel = "NAME",
            description = "Look that a page offers; can be repeated (default: all looks of the scene).")
    private List<String> looks = List.of();
    @Option(names = "--no-looks", description = "Write a page without looks.")
    private boolean noLooks;
    @Option(names = "--language", paramLabel = "en|de", description = "Language of a page (default: the browser's).")
    private @Nullable PageLanguage language;

    /** Letters of languages, as on the command line. */
    enum PageLanguage {
        EN, DE
    }

    /** Refuses options that nothing would use. */
    void check(boolean writesPage) throws BadInputException {
        if (!writesPage && (!frames.isEmpty() || !looks.isEmpty() || noLooks || language != null)) {
            throw new BadInputException("review: --frames, --look, --no-looks and --language are of a page that -o writes");
        }
        if (noLooks && !looks.isEmpty()) {
            throw new BadInputException("review: expected one of --look and --no-looks");
        }
    }

    /** Returns what a page of a scene file shows; prints a line for each look that it cannot show. */
    ReviewContent content(JenDocument document, Path file, PictureOptions picture, ViewOption view, Console console)
            throws IOException, BadInputException {
        List<Look> looks = looks(file, document.scene());
        ReviewLooks.of(looks, document.scene()).problems().forEach(problem -> console.warn("%s", problem));
        List<ReviewPicture> pictures;
        boolean isFilm = !frames.isEmpty() || document.shot().filter(shot -> shot.last() > shot.first()).isPresent();
        Scene base = picture.apply(document.scene());
        if (isFilm) {
            Shot shot = document.shot().orElseThrow(() -> new BadInputException(Console.text(
                    "%s: has no shot block (see docs/jen-format.md)", file)));
            Scene small = picture.hasSize() ? base : ReviewFilm.reduced(base);
            pictures = film(looks, shot, small);
        } else {
            pictures = List.of(new ReviewPicture(OptionalInt.empty(), base, ReviewLooks.of(looks, base).looks()));
        }
        Optional<Language> chosen = Optional.ofNullable(language).map(l -> l == PageLanguage.DE ? Language.GERMAN : Language.ENGLISH);
        var content = new ReviewContent(file.getFileName().toString(), base, pictures, view.of(base), chosen);
        content.check();
        return content;
    }

    private List<ReviewPicture> film(List<Look> looks, Shot shot, Scene scene) throws BadInputException {
        List<Integer> chosen = chosenFrames(shot);
        try {
            return ReviewLooks.film(looks, shot, scene, chosen);
        } catch (RefusalException e) {
            throw new BadInputException(e.getMessage());
        }
    }

    private List<Look> looks(Path file, Scene scene) throws IOException, BadInputException {
        if (noLooks) {
            return List.of();
        }
        List<Look> all = new LookFiles(file).list(scene.stage());
        for (String name : looks) {
            if (all.stream().noneMatch(look -> look.name().equals(name))) {
                throw new BadInputException(Console.text("--look: the scene has no look %s; it has %s", Quote.of(name),
                        all.isEmpty() ? "none" : String.join(", ", all.stream().map(Look::name).toList())));
            }
        }
        return looks.isEmpty() ? all : all.stream().filter(look -> looks.contains(look.name())).toList();
    }

    private List<Integer> chosenFrames(Shot shot) throws BadInputException {
        if (frames.isEmpty()) {
            return ReviewFilm.frames(shot);
        }
        for (int frame : frames) {
            if (frame < shot.first() || frame > shot.last()) {
                throw new BadInputException("--frames: expected frames from " + shot.first() + " to " + shot.last() + ", found " + frame);
            }
        }
        List<Integer> distinct = frames.stream().distinct().toList();
        if (distinct.size() > MAX_FRAMES) {
            throw new BadInputException("--frames: expected at most " + MAX_FRAMES + " frames, found " + distinct.size());
        }
        return distinct;
    }
}
