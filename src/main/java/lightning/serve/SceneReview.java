package lightning.serve;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.CancellationException;
import lightning.base.text.RefusalException;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.SceneView;
import lightning.review.Review;
import lightning.review.live.LiveAddress;
import lightning.review.live.LiveChange;
import lightning.review.live.LiveReview;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.NullNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Live review page of an open scene, at an address of this computer. It follows the scene's edits, and changes lights if the client allowed
 * it. Its exact pictures are rendered when the scene has no other request. Methods without a note run on the scene's thread.
 */
final class SceneReview implements AutoCloseable {
    /** Pages whose notes are stored. */
    private static final int MAX_PAGES = 100;

    private final SceneSession session;
    /** Client that opened it; owns the updates of its pictures. */
    private final Client client;
    private final boolean allowsEdits;
    private final LiveReview live;
    private final SequencedMap<String, LiveChange> newest = new LinkedHashMap<>();
    private int changes;
    /** Scenes of the values and of the exact picture that pages have. */
    private @Nullable Scene shownValues;
    private @Nullable Scene shownPicture;
    /** Render that is waiting or running for the pages. */
    private volatile @Nullable Request update;

    /** @param last review that this one replaces; its notes stay */
    SceneReview(SceneSession session, Client client, boolean allowsEdits, Optional<SceneReview> last) throws IOException {
        this.session = session;
        this.client = client;
        this.allowsEdits = allowsEdits;
        last.ifPresent(review -> newest.putAll(review.newest));
        changes = last.map(review -> review.changes).orElse(0);
        live = LiveReview.start(String.valueOf(session.document().file().getFileName()), LiveAddress.LOCAL, allowsEdits,
                change -> session.runLater(() -> change(change)));
    }

    boolean allowsEdits() {
        return allowsEdits;
    }

    ObjectNode describe() {
        ObjectNode node =
                JsonLines.JSON.createObjectNode().put("url", live.url()).put("allow_edits", allowsEdits).put("pages", live.pages())
                        .put("changes", changes);
        ArrayNode notes = node.putArray("notes");
        for (LiveChange change : newest.values()) {
            for (Review.Note note : change.notes()) {
                notes.addObject().put("reviewer", change.reviewer()).put("x", note.x()).put("y", note.y()).put("text", note.text());
            }
        }
        return live.problem().isEmpty() ? node : node.put("problem", live.problem());
    }

    /** Cancels a render for the pages, so that a request of a client does not wait for it. Any thread. */
    void yieldToRequest() {
        Request running = update;
        if (running != null) {
            running.cancel();
            session.server().wakeCanceled();
        }
    }

    private void change(LiveChange change) {
        change.storeNotes(newest);
        if (newest.size() > MAX_PAGES) {
            newest.pollFirstEntry();
        }
        String page = change.page();
        try {
            if (session.editByPage(change.state().applyTo(session.scene()), page)) {
                changes++;
            }
        } catch (RequestException | RefusalException e) {
            // The scene does not allow it: the page gets the scene's values again.
            shownValues = null;
            page = "";
        }
        follow(page);
    }

    /**
     * Shows the scene as it is now: its values at once, its exact picture after the requests that wait.
     *
     * @param page page that made the change; empty for none
     */
    void follow(String page) {
        Scene scene = session.scene();
        if (scene != shownValues) {
            live.show(scene, page);
            shownValues = scene;
        }
        if (scene != shownPicture) {
            yieldToRequest();
            Request next = new Request(client, NullNode.getInstance(), Method.REVIEW, new Fields(JsonLines.JSON.createObjectNode()));
            update = next;
            session.runLater(() -> render(next));
        }
    }

    private void render(Request request) {
        if (!request.isCanceled()) {
            try {
                session.update(request, 0);
                showPicture();
            } catch (CancellationException | RequestException | PictureTooLargeException e) {
                // A request came, which follows again, or the picture cannot be rendered, which the client's next render reports.
            }
        }
    }

    /** Shows the exact picture, which the renderer has. */
    void showPicture() {
        shownPicture = session.scene();
        live.show(session.renderer().cache(), session.renderer().options(), SceneView.of(shownPicture));
    }

    @Override
    public void close() {
        yieldToRequest();
        live.close();
    }
}
