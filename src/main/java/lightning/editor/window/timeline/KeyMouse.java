package lightning.editor.window.timeline;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import javafx.scene.Node;
import javafx.scene.control.ListView;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import lightning.editor.document.KeyEdits;
import lightning.editor.document.KeyPlace;
import lightning.editor.document.Selection;
import lightning.editor.document.Workbench;
import lightning.editor.window.model.KeyChoice;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Target;

/**
 * The mouse among the lines: a press chooses a key, with Ctrl one more, and a drag moves all that are chosen; on a name it chooses all keys of
 * the line and selects what has them; two clicks beside a key make one.
 */
final class KeyMouse {
    private final Timeline timeline;
    private final ListView<Row> rows;
    private final Workbench workbench;
    private final SceneEditor editor;
    private final KeyChoice keyChoice;
    private Drag drag;

    /** @param keys where they were when it began */
    private record Drag(AnimatedScene before, Set<KeyPlace> keys, double x, Object gesture) {}

    private KeyMouse(Timeline timeline, ListView<Row> rows, Workbench workbench) {
        this.timeline = timeline;
        this.rows = rows;
        this.workbench = workbench;
        editor = timeline.editor();
        keyChoice = timeline.keyChoice();
    }

    static void follow(Timeline timeline, ListView<Row> rows, Workbench workbench) {
        var mouse = new KeyMouse(timeline, rows, workbench);
        rows.addEventFilter(MouseEvent.MOUSE_PRESSED, mouse::press);
        rows.addEventFilter(MouseEvent.MOUSE_DRAGGED, mouse::drag);
        rows.addEventFilter(MouseEvent.MOUSE_RELEASED, _ -> mouse.release());
    }

    private void press(MouseEvent event) {
        Node hit = event.getPickResult().getIntersectedNode();
        TrackCell cell = cell(hit);
        if (cell == null || cell.isEmpty() || editor.isAnimating()) {
            return;
        }
        rows.requestFocus();
        boolean more = event.isShortcutDown() || event.isShiftDown();
        if (hit.getUserData() instanceof Lane.Mark(List<KeyPlace> keys)) {
            choose(keys, more, event.getButton());
            drag = event.getButton() == MouseButton.PRIMARY
                    ? new Drag(editor.document().content(), keyChoice.keys(), event.getX(), new Object()) : null;
        } else if (rows.sceneToLocal(event.getSceneX(), event.getSceneY()).getX() < TrackCell.NAME) {
            select(cell.getItem().target());
            choose(cell.getItem().tracks().stream().flatMap(t -> t.keys().stream()
                    .map(k -> new KeyPlace(t.target(), t.attribute(), k.frame()))).toList(), more, event.getButton());
        } else if (event.getButton() == MouseButton.PRIMARY && event.getClickCount() == 2) {
            key(cell.getItem(), timeline.scaleProperty().get().frame(event.getX() - TrackCell.NAME));
        } else if (event.getButton() == MouseButton.PRIMARY && !more) {
            keyChoice.set(Set.of());
        }
        if (event.getButton() == MouseButton.PRIMARY) {
            event.consume();
        }
    }

    private static TrackCell cell(Node hit) {
        Node node = hit;
        while (node != null && !(node instanceof TrackCell)) {
            node = node.getParent();
        }
        return (TrackCell) node;
    }

    private void choose(List<KeyPlace> keys, boolean more, MouseButton button) {
        Set<KeyPlace> chosen = keyChoice.keys();
        boolean all = chosen.containsAll(keys);
        if (more) {
            Set<KeyPlace> other = new HashSet<>(chosen);
            if (all) {
                other.removeAll(keys);
            } else {
                other.addAll(keys);
            }
            keyChoice.set(other);
        } else if (!all || button == MouseButton.PRIMARY && chosen.size() == keys.size()) {
            keyChoice.set(Set.copyOf(keys));
        }
    }

    private void select(Target target) {
        switch (target.what()) {
            case LIGHT -> editor.selection().selectLight(target.name());
            case NODE -> workbench.select(new Selection.OfNode(target.name()));
            case CAMERA, BANK -> {
                // Neither can be selected.
            }
        }
    }

    /** A key that says what is there at that frame, which is shown. */
    private void key(Row row, int frame) {
        editor.showFrame(frame);
        editor.document().moment().ifPresent(now -> editor.editAllOrReport(scene -> {
            AnimatedScene keyed = scene;
            for (var track : row.tracks()) {
                keyed = KeyEdits.key(keyed, editor.scene(), track.target(), track.attribute(), now.frame());
            }
            return keyed;
        }, null));
    }

    private void drag(MouseEvent event) {
        if (drag == null) {
            return;
        }
        timeline.hold(true);
        FrameScale scale = timeline.scaleProperty().get();
        int by = KeyEdits.within(drag.keys(), scale.frame(event.getX() - TrackCell.NAME) - scale.frame(drag.x() - TrackCell.NAME));
        Drag now = drag;
        if (editor.editAllOrReport(_ -> KeyEdits.later(now.before(), now.keys(), by), now.gesture()).isEmpty()) {
            keyChoice.set(now.keys().stream().map(k -> k.later(by)).collect(Collectors.toSet()));
        }
        event.consume();
    }

    private void release() {
        drag = null;
        timeline.hold(false);
    }
}
