package lightning.editor.window.mixer;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.scene.Node;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import lightning.document.EditOutcome;
import lightning.document.MixerChannel;
import lightning.document.MixerEdits;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import org.jspecify.annotations.Nullable;

/** Mouse handler of the strips' headers: a click selects, a drag reorders the lights of the scene. */
final class StripDrag {
    /** Maximum movement of a click, pixels. */
    private static final double CLICK_TOLERANCE = 5;

    private final MixerModel model;
    private final Supplier<List<MixerStrip>> shownStrips;
    private @Nullable MixerStrip pressed;
    private double pressX;
    private boolean dragging;

    /**
     * Creates the handler.
     *
     * @param shownStrips returns the visible strips from left to right
     */
    StripDrag(MixerModel model, Supplier<List<MixerStrip>> shownStrips) {
        this.model = model;
        this.shownStrips = shownStrips;
    }

    void attach(HBox row) {
        row.addEventHandler(MouseEvent.MOUSE_PRESSED, this::press);
        row.addEventHandler(MouseEvent.MOUSE_DRAGGED, this::drag);
        row.addEventHandler(MouseEvent.MOUSE_RELEASED, this::release);
    }

    private void press(MouseEvent e) {
        pressed = shownStrips.get().stream().filter(s -> isInside(e, s.head())).findFirst().orElse(null);
        pressX = e.getSceneX();
        dragging = false;
    }

    private static boolean isInside(MouseEvent e, Node part) {
        for (Node n = e.getTarget() instanceof Node target ? target : null; n != null; n = n.getParent()) {
            if (n == part) {
                return true;
            }
        }
        return false;
    }

    private void drag(MouseEvent e) {
        if (pressed != null && pressed.channel().canBeMoved()
                && (dragging || Math.abs(e.getSceneX() - pressX) > CLICK_TOLERANCE)) {
            dragging = true;
            pressed.setDragged(true);
            Optional<MixerStrip> next = dropTarget(pressed.channel(), e.getSceneX());
            shownStrips.get().forEach(s -> s.setDropTarget(next.isPresent() && s == next.get()));
        }
    }

    /** Returns the strip before which a dragged one would be dropped; empty at the end. */
    private Optional<MixerStrip> nextStrip(double x) {
        return shownStrips.get().stream().filter(s -> s.localToScene(s.getBoundsInLocal()).getCenterX() > x).findFirst();
    }

    /** Returns the drop target. A light group can be dropped only before a light group or at the end. */
    private Optional<MixerStrip> dropTarget(MixerChannel dragged, double x) {
        return dragged instanceof MixerChannel.OfLightGroup
                ? shownStrips.get().stream().filter(s -> s.channel() instanceof MixerChannel.OfLightGroup)
                        .filter(s -> s.localToScene(s.getBoundsInLocal()).getCenterX() > x).findFirst()
                : nextStrip(x);
    }

    private void release(MouseEvent e) {
        if (pressed == null) {
            return;
        }
        MixerStrip strip = pressed;
        pressed = null;
        shownStrips.get().forEach(s -> s.setDropTarget(false));
        strip.setDragged(false);
        if (dragging) {
            Optional<MixerStrip> next = dropTarget(strip.channel(), e.getSceneX());
            if (next.isEmpty() || next.get() != strip) {
                model.edit(scene -> switch (strip.channel()) {
                    case MixerChannel.OfContribution(SceneElement.OfLight(String light)) -> dropLight(scene, light, next);
                    case MixerChannel.OfLightGroup(String group) ->
                            MixerEdits.moveLightGroup(scene, group, next.map(s -> s.channel().title(scene)));
                    case MixerChannel.OfContribution _ -> new EditOutcome.Applied(scene);
                }, null);
            }
        } else if (e.isShiftDown()) {
            model.selectRange(strip.channel(), shownStrips.get().stream().map(MixerStrip::channel).toList());
        } else if (e.isShortcutDown()) {
            model.toggle(strip.channel());
        } else {
            model.select(strip.channel());
        }
    }

    private EditOutcome dropLight(Scene scene, String light, Optional<MixerStrip> next) {
        if (next.isPresent() && next.get().channel() instanceof MixerChannel.OfContribution(SceneElement.OfLight(String before))) {
            return MixerEdits.moveBefore(scene, light, before);
        }
        List<MixerStrip> strips = shownStrips.get();
        int index = next.map(strips::indexOf).orElse(strips.size());
        // Drop after the last preceding strip of a light or light group.
        for (int i = index - 1; i >= 0; i--) {
            switch (strips.get(i).channel()) {
                case MixerChannel.OfContribution(SceneElement.OfLight(String name)) -> {
                    return MixerEdits.moveToEnd(scene, light, scene.light(name).map(l -> l.lightGroup()).orElse(""));
                }
                case MixerChannel.OfLightGroup(String group) -> {
                    return MixerEdits.moveToEnd(scene, light, group);
                }
                case MixerChannel.OfContribution _ -> {
                    // The strips of environments are after all lights.
                }
            }
        }
        return MixerEdits.moveToEnd(scene, light, "");
    }
}
