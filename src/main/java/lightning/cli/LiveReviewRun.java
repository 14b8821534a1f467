package lightning.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CancellationException;
import java.util.concurrent.LinkedBlockingQueue;
import lightning.base.text.PrintableText;
import lightning.cli.output.Console;
import lightning.cli.output.ProgressBar;
import lightning.cli.output.ViewOption;
import lightning.format.jen.JenDocument;
import lightning.format.review.Review;
import lightning.format.review.live.LiveChange;
import lightning.format.review.live.LiveReview;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * A live review without an editor: changes of pages are rendered, and saved if a file is given.
 *
 * @param title name of the scene
 */
record LiveReviewRun(Console console, String title, RenderOptions options, ViewOption view) {
    /** Serves the page until the command is canceled. */
    void run(JenDocument document, LiveReviewOptions live, @Nullable Path output) throws Exception {
        BlockingQueue<LiveChange> changes = new LinkedBlockingQueue<>();
        Map<String, List<Review.Note>> printed = new HashMap<>();
        JenDocument current = document;
        try (LiveReview review = LiveReview.start(title, live.where(), live.allowsEdits(), changes::add);
                Renderer renderer = new Renderer(options)) {
            render(renderer, current.scene(), review, "");
            console.print("%s: open it in a browser; press Ctrl-C to stop", review.url());
            console.out().flush();
            while (true) {
                List<LiveChange> next = new ArrayList<>(List.of(changes.take()));
                changes.drainTo(next);
                Scene before = current.scene();
                for (LiveChange change : next) {
                    current = current.withScene(change.state().applyTo(current.scene()));
                    print(change, current.scene(), printed);
                }
                if (!current.scene().equals(before)) {
                    render(renderer, current.scene(), review, next.getLast().page());
                    if (output != null) {
                        current.save(output);
                    }
                }
            }
        } catch (InterruptedException e) {
            throw new CancellationException();
        }
    }

    private void render(Renderer renderer, Scene scene, LiveReview review, String page) {
        review.show(scene, page);
        try (ProgressBar bar = new ProgressBar(console, "tracing")) {
            renderer.render(scene, bar);
        }
        review.show(renderer.cache(), options, view.of(scene));
    }

    private void print(LiveChange change, Scene scene, Map<String, List<Review.Note>> printed) {
        List<Review.Note> before = printed.getOrDefault(change.page(), List.of());
        String reviewer = change.reviewer().isBlank() ? "an unnamed reviewer" : PrintableText.escape(change.reviewer());
        for (Review.Note note : change.notes()) {
            if (!before.contains(note)) {
                console.print("%s, %d,%d: %s", reviewer, (int) (note.x() * scene.picture().width()),
                        (int) (note.y() * scene.picture().height()), PrintableText.escape(note.text()));
            }
        }
        console.out().flush();
        printed.put(change.page(), change.notes());
    }
}
