package lightning.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CancellationException;
import java.util.concurrent.LinkedBlockingQueue;
import lightning.cli.output.Console;
import lightning.cli.output.ProgressBar;
import lightning.cli.output.ViewOption;
import lightning.format.jen.JenDocument;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.review.live.LiveReview;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * A live review without an editor: changes of pages are saved if a file is given, and rendered.
 *
 * @param title name of the scene
 */
record LiveReviewRun(Console console, String title, RenderOptions options, ViewOption view) {
    /** Serves the page until the command is canceled. */
    void run(JenDocument document, LiveReviewOptions live, @Nullable Path output) throws Exception {
        BlockingQueue<String> pages = new LinkedBlockingQueue<>();
        var edited = new LiveDocument(console, document, output);
        try (LiveReview review = LiveReview.start(title, live.where(), live.allowsEdits(), change -> pages.add(edited.apply(change)));
                Renderer renderer = new Renderer(options)) {
            Scene shown = edited.scene();
            render(renderer, shown, review, "");
            console.print("%s: open it in a browser; press Ctrl-C to stop", review.url());
            console.out().flush();
            while (true) {
                List<String> changed = new ArrayList<>(List.of(pages.take()));
                pages.drainTo(changed);
                Scene scene = edited.scene();
                String page = changed.contains("") ? "" : changed.getLast();
                if (!scene.equals(shown)) {
                    render(renderer, scene, review, page);
                    shown = scene;
                } else if (page.isEmpty()) {
                    review.show(scene, "");
                }
            }
        } catch (InterruptedException e) {
            throw new CancellationException();
        } finally {
            // An interrupted thread cannot write.
            boolean isInterrupted = Thread.interrupted();
            edited.save();
            if (isInterrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private void render(Renderer renderer, Scene scene, LiveReview review, String page) {
        review.show(scene, page);
        try (ProgressBar bar = new ProgressBar(console, "tracing")) {
            renderer.render(scene, bar);
        }
        review.show(renderer.cache(), options, view.of(scene));
    }
}
