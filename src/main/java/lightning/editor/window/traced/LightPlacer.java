package lightning.editor.window.traced;

import java.util.Optional;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import lightning.base.math.Vec3;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.LightEdits;
import lightning.editor.document.LightPlacing;
import lightning.editor.document.LightPlacing.Act;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.ScenePicker;
import lightning.editor.document.Snap;
import lightning.editor.document.Viewport;
import lightning.editor.loop.Frame;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.widget.PictureView;
import lightning.scene.Light;

/**
 * Places the selected light by what it does in the traced picture: a press does it there, a drag goes on with it from surface to surface.
 * Then a ring about the place stays, whose drag takes the light nearer or farther; it goes with the next edit that is not its own.
 */
final class LightPlacer {
    /** The ring's radius, pixels. */
    static final double RING = 40;

    private static final String NOTHING = Texts.key("There is nothing there; click a shape");

    private final SceneEditor editor;
    private final ReadOnlyStringWrapper prompt = new ReadOnlyStringWrapper("");
    private Tool tool;
    private Drag drag;
    /** Of the drag: what makes it one step, and the light before it. */
    private Object gesture;
    private Light before;
    private Ring ring;

    /** What the next press is for. */
    private sealed interface Tool {
        /** It does that, wherever it is. */
        record Acting(Act act) implements Tool {}

        /** It takes what throws a shadow, or a shadow. */
        record Taking() implements Tool {}
    }

    /** What is under the mouse while the button is down. */
    private sealed interface Drag {
        /** @param picker finds surfaces of the picture that is shown */
        record Placing(LightPlacing placing, ScenePicker picker) implements Drag {}

        /** @param from where the shadow, or what throws it, was taken */
        record Shadow(Light begin, ScenePicker.Found from, ScenePicker picker) implements Drag {}

        record Farther(Ring ring, Viewport.Pixel from) implements Drag {}
    }

    /**
     * A placed light.
     *
     * @param light as it is now
     */
    private record Ring(LightPlacing placing, ScenePicker.Found at, Light light) {}

    private LightPlacer(SceneEditor editor) {
        this.editor = editor;
        editor.situationProperty().subscribe(_ -> {
            if (drag == null && ring != null && !ring.light().equals(editor.selection().light())) {
                ring = null;
            }
        });
    }

    /** Does the commands that place a light. */
    static LightPlacer of(SceneEditor editor, Commands commands) {
        var placer = new LightPlacer(editor);
        commands.setAction(Command.AIM,
                () -> placer.take(Texts.of("Click where the light should shine to, or drag its pool"), new Act.Pool()));
        commands.setAction(Command.PLACE_HIGHLIGHT,
                () -> placer.take(Texts.of("Click where the highlight should be, or drag it there"), new Act.Highlight()));
        commands.setAction(Command.PLACE_DIFFUSE,
                () -> placer.take(Texts.of("Click what the light should shine straight onto, or drag"), new Act.Diffuse()));
        commands.setAction(Command.PLACE_RIM,
                () -> placer.take(Texts.of("Click where the rim of light should begin, or drag"), new Act.Rim()));
        commands.setAction(Command.PLACE_SHADOW,
                () -> placer.take(new Tool.Taking(), Texts.of("Drag a shadow or what throws it, or click what throws it")));
        return placer;
    }

    private void take(String hint, Act act) {
        take(new Tool.Acting(act), hint);
    }

    private void take(Tool taken, String hint) {
        tool = taken;
        ring = null;
        prompt.set(hint);
    }

    /**
     * Where the mouse is.
     *
     * @param pixel  of the picture; empty beside it
     * @param canvas the size of the whole picture as it is shown
     * @param at     on that
     */
    record Pointer(Optional<PictureView.Pixel> pixel, Viewport canvas, Viewport.Pixel at) {
        Optional<ScenePicker.Found> on(ScenePicker picker) {
            return pixel.flatMap(p -> picker.atPixel(p.x(), p.y()));
        }
    }

    /** What the artist shall do; empty where no tool is taken. */
    ReadOnlyStringProperty promptProperty() {
        return prompt.getReadOnlyProperty();
    }

    /** Puts the tool away. */
    void end() {
        tool = null;
        prompt.set("");
    }

    /** Takes the ring away; returns whether there was one. */
    boolean endRing() {
        boolean there = ring != null;
        ring = null;
        return there;
    }

    /** Whether a press took something. */
    boolean isDragging() {
        return drag != null;
    }

    /** Where the ring is drawn on a canvas that shows the whole picture, and how far the light is from there; empty where there is none. */
    Optional<Mark> mark(Viewport canvas) {
        return Optional.ofNullable(ring).filter(r -> r.light().type().hasPosition())
                .map(r -> new Mark(middle(r, canvas), r.light().position().minus(r.at().point()).length()));
    }

    /** @param distance from the place to the light, as it is now */
    record Mark(Viewport.Pixel middle, double distance) {}

    private Viewport.Pixel middle(Ring r, Viewport canvas) {
        return canvas.pixel(PreviewCamera.of(editor.scene()), r.at().point());
    }

    /** Takes what is there with the tool, or the ring; returns whether there is something to drag. */
    boolean press(Pointer to, double tolerance) {
        Frame frame = editor.situationProperty().get().frame().orElse(null);
        gesture = new Object();
        before = editor.selection().light();
        if (tool == null) {
            boolean taken = mark(to.canvas()).filter(m -> Math.abs(m.middle().distance(to.at()) - RING) <= tolerance).isPresent();
            drag = taken ? new Drag.Farther(ring, to.at()) : null;
        } else if (before == null) {
            editor.message().show(Texts.of("No light is selected"));
        } else if (frame != null) {
            ScenePicker picker = ScenePicker.of(frame.scene(), frame.geometry());
            to.on(picker).ifPresentOrElse(found -> {
                switch (tool) {
                    case Tool.Acting(Act act) -> {
                        var placing = LightPlacing.from(before, act, found.point());
                        drag = new Drag.Placing(placing, picker);
                        place(placing, found, false);
                    }
                    case Tool.Taking() -> drag = new Drag.Shadow(before, found, picker);
                }
            }, () -> editor.message().show(Texts.of(NOTHING)));
        }
        return drag != null;
    }

    /** @param snapped whether distances are rounded, and aims */
    void drag(Pointer to, boolean snapped) {
        switch (drag) {
            case Drag.Placing(LightPlacing placing, ScenePicker picker) -> to.on(picker).ifPresent(found -> place(placing, found, snapped));
            case Drag.Shadow(Light begin, ScenePicker.Found from, ScenePicker picker) -> {
                // Of a shadow, what throws it is what stands between; of anything else it is that itself.
                Act act = new Act.Shadow(picker.between(from, begin).orElse(from).point());
                drag = new Drag.Placing(LightPlacing.from(begin, act, from.point()), picker);
                drag(to, snapped);
            }
            case Drag.Farther(Ring begin, Viewport.Pixel from) -> {
                Viewport.Pixel middle = middle(begin, to.canvas());
                Vec3 point = begin.at().point();
                double factor = to.at().distance(middle) / Math.max(1, from.distance(middle));
                double wanted = begin.light().position().minus(point).length() * factor;
                show(begin.placing(), begin.at(),
                        begin.placing().atDistance(begin.light(), point, snapped ? Snap.distance(wanted) : wanted),
                        Optional.empty());
            }
        }
    }

    private void place(LightPlacing placing, ScenePicker.Found found, boolean snapped) {
        boolean pool = placing.act() instanceof Act.Pool;
        LightPlacing rounded = snapped && !pool ? placing.withDistance(Snap.distance(placing.distance())) : placing;
        try {
            Light light = rounded.at(found);
            Optional<Snap> snap = snapped && pool ? Optional.of(Snap.ofDirection(light)) : Optional.empty();
            show(rounded, found, snap.map(Snap::light).orElse(light), snap.map(Snap::told));
        } catch (IllegalArgumentException e) {
            editor.message().show(Sentence.of(e));
        }
    }

    private void show(LightPlacing placing, ScenePicker.Found at, Light light, Optional<String> snapped) {
        if (editor.editOrReport(scene -> LightEdits.with(scene, light.name(), _ -> light), gesture).isEmpty()) {
            ring = new Ring(placing, at, light);
            double distance = light.position().minus(at.point()).length();
            editor.message().show(snapped.map(s -> Texts.of("Snapped: {0}", s))
                    .orElse(light.type().hasPosition() ? Texts.of("Distance {0}", Snap.number(distance)) : ""));
        }
    }

    /** @param still whether the mouse has not moved since the press */
    void release(boolean still) {
        if (drag instanceof Drag.Shadow(Light _, ScenePicker.Found from, ScenePicker _) && still) {
            take(Texts.of("Click where the shadow should fall, or drag it there"), new Act.Shadow(from.point()));
        } else {
            end();
        }
        drag = null;
    }

    /** Takes back what the drag did, and puts the tool away. */
    void giveUp() {
        editor.edit(scene -> LightEdits.with(scene, before.name(), _ -> before), gesture);
        drag = null;
        ring = null;
        end();
    }
}
