package lightning.editor.window.timeline;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import javafx.scene.Node;
import javafx.scene.control.ListView;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import lightning.document.KeyEdits;
import lightning.document.KeyId;
import lightning.document.Selection;
import lightning.editor.Workbench;
import lightning.editor.window.model.KeySelection;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.SceneElement;
import lightning.scene.shot.AnimatedScene;
import org.jspecify.annotations.Nullable;

/**
 * Mouse handler of the timeline's rows. A press selects a keyframe, Ctrl adds to the selection, and a drag moves all selected keyframes. A
 * press on a name selects all keyframes of the row and their object. A double-click on an empty position adds a keyframe.
 */
final class KeyframeMouse {
    private final TimelineModel timeline;
    private final ListView<TimelineRow> rows;
    private final Workbench workbench;
    private final SceneEditor editor;
    private final KeySelection keyChoice;
    private @Nullable Drag drag;

    /**
     * Drag in progress.
     *
     * @param keys keyframes at their start positions
     */
    private record Drag(AnimatedScene startContent, Set<KeyId> keys, double x, Object gesture) {}

    private KeyframeMouse(TimelineModel timeline, ListView<TimelineRow> rows, Workbench workbench) {
        this.timeline = timeline;
        this.rows = rows;
        this.workbench = workbench;
        editor = timeline.editor();
        keyChoice = timeline.keyChoice();
    }

    static void attach(TimelineModel timeline, ListView<TimelineRow> rows, Workbench workbench) {
        var mouse = new KeyframeMouse(timeline, rows, workbench);
        rows.addEventFilter(MouseEvent.MOUSE_PRESSED, mouse::press);
        rows.addEventFilter(MouseEvent.MOUSE_DRAGGED, mouse::drag);
        rows.addEventFilter(MouseEvent.MOUSE_RELEASED, _ -> mouse.release());
    }

    private void press(MouseEvent event) {
        Node hit = event.getPickResult().getIntersectedNode();
        TrackCell cell = cell(hit);
        if (cell == null || cell.isEmpty()) {
            return;
        }
        rows.requestFocus();
        boolean extend = event.isShortcutDown() || event.isShiftDown();
        if (hit.getUserData() instanceof KeyframeLane.KeyMark(List<KeyId> keys)) {
            choose(keys, extend, event.getButton());
            drag = event.getButton() == MouseButton.PRIMARY
                    ? new Drag(editor.document().content(), keyChoice.keys(), event.getX(), new Object()) : null;
        } else if (rows.sceneToLocal(event.getSceneX(), event.getSceneY()).getX() < TrackCell.NAME_WIDTH) {
            select(cell.getItem().target());
            choose(cell.getItem().tracks().stream().flatMap(t -> t.keys().stream()
                    .map(k -> new KeyId(t.target(), t.attribute(), k.frame()))).toList(), extend, event.getButton());
        } else if (event.getButton() == MouseButton.PRIMARY && event.getClickCount() == 2) {
            addKeyframe(cell.getItem(), timeline.scaleProperty().get().frame(event.getX() - TrackCell.NAME_WIDTH));
        } else if (event.getButton() == MouseButton.PRIMARY && !extend) {
            keyChoice.set(Set.of());
        }
        if (event.getButton() == MouseButton.PRIMARY) {
            event.consume();
        }
    }

    private static @Nullable TrackCell cell(@Nullable Node hit) {
        Node node = hit;
        while (node != null && !(node instanceof TrackCell)) {
            node = node.getParent();
        }
        return (TrackCell) node;
    }

    private void choose(List<KeyId> keys, boolean extend, MouseButton button) {
        Set<KeyId> chosen = keyChoice.keys();
        boolean allChosen = chosen.containsAll(keys);
        if (extend) {
            Set<KeyId> updated = new HashSet<>(chosen);
            if (allChosen) {
                updated.removeAll(keys);
            } else {
                updated.addAll(keys);
            }
            keyChoice.set(updated);
        } else if (!allChosen || button == MouseButton.PRIMARY && chosen.size() == keys.size()) {
            keyChoice.set(Set.copyOf(keys));
        }
    }

    private void select(SceneElement<?> target) {
        if (target instanceof SceneElement.OfLight(String name)) {
            editor.selection().selectLight(name);
        } else if (target instanceof SceneElement.OfNode(String name)) {
            workbench.select(new Selection.OfNode(name));
        }
    }

    /** Adds keyframes with the current values at a frame and shows that frame. */
    private void addKeyframe(TimelineRow row, int frame) {
        editor.showFrame(frame);
        editor.document().shotFrame().ifPresent(now -> editor.editShotOrReport(scene -> {
            AnimatedScene keyed = scene;
            for (var track : row.tracks()) {
                keyed = KeyEdits.setKey(keyed, editor.scene(), track.target(), track.attribute(), now.frame());
            }
            return keyed;
        }, null));
    }

    private void drag(MouseEvent event) {
        if (drag == null) {
            return;
        }
        timeline.setDragging(true);
        FrameScale scale = timeline.scaleProperty().get();
        int frameOffset = KeyEdits.clampShift(drag.keys(),
                scale.frame(event.getX() - TrackCell.NAME_WIDTH) - scale.frame(drag.x() - TrackCell.NAME_WIDTH));
        Drag currentDrag = drag;
        if (editor.editShotOrReport(_ -> KeyEdits.shiftKeys(currentDrag.startContent(), currentDrag.keys(), frameOffset),
                currentDrag.gesture()).isEmpty()) {
            keyChoice.set(currentDrag.keys().stream().map(k -> k.shifted(frameOffset)).collect(Collectors.toSet()));
        }
        event.consume();
    }

    private void release() {
        drag = null;
        timeline.setDragging(false);
    }
}
