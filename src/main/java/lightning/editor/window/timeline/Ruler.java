package lightning.editor.window.timeline;

import java.util.ArrayList;
import java.util.List;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Region;
import lightning.base.text.Messages;
import lightning.scene.shot.Shot;

/** Ruler with frame numbers; a press or a drag shows the frame at that position. */
final class Ruler extends Pane {
    static final double HEIGHT = 22;
    private static final double TICK = 5;

    private final TimelineModel timeline;

    Ruler(TimelineModel timeline) {
        this.timeline = timeline;
        setId("timeline-ruler");
        getStyleClass().add("ruler");
        setAccessibleText(Messages.tr("frames"));
        setMinHeight(HEIGHT);
        setMaxHeight(HEIGHT);
        timeline.scaleProperty().subscribe(_ -> draw());
        timeline.shotProperty().subscribe(_ -> draw());
        addEventHandler(MouseEvent.MOUSE_PRESSED, this::scrub);
        addEventHandler(MouseEvent.MOUSE_DRAGGED, this::scrub);
    }

    private void scrub(MouseEvent event) {
        if (event.getButton() == MouseButton.PRIMARY && timeline.shotProperty().get() != null) {
            int frame = timeline.scaleProperty().get().frame(event.getX());
            if (timeline.editor().document().shotFrame().filter(m -> m.frame() == frame).isEmpty()) {
                timeline.editor().showFrame(frame);
            }
            event.consume();
        }
    }

    private void draw() {
        Shot shot = timeline.shotProperty().get();
        FrameScale scale = timeline.scaleProperty().get();
        List<Node> parts = new ArrayList<>();
        if (shot != null) {
            parts.add(part("shot-range", scale.x(shot.first()), 0, scale.x(shot.last()) - scale.x(shot.first()), HEIGHT));
            for (int frame : scale.labeledFrames()) {
                parts.add(part("tick", scale.x(frame), HEIGHT - TICK, 1, TICK));
                var number = new Label(String.valueOf(frame));
                number.getStyleClass().add("frame-number");
                number.setManaged(false);
                number.setMouseTransparent(true);
                number.relocate(scale.x(frame) + 3, 2);
                number.autosize();
                parts.add(number);
            }
        }
        getChildren().setAll(parts);
        parts.stream().filter(Label.class::isInstance).forEach(label -> {
            label.applyCss();
            label.autosize();
        });
    }

    private static Region part(String style, double x, double y, double width, double height) {
        var part = new Region();
        part.getStyleClass().add(style);
        part.setManaged(false);
        part.setMouseTransparent(true);
        part.resizeRelocate(x, y, Math.max(1, width), height);
        return part;
    }
}
