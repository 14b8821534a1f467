package lightning.editor.window.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import javafx.util.Duration;
import org.junit.jupiter.api.Test;

class DelayedMessageTest {
    private final ManualScheduler scheduler = new ManualScheduler();
    private final List<String> shown = new ArrayList<>();
    private final DelayedMessage message = new DelayedMessage(scheduler, DelayedMessage.MIN_DURATION, shown::add);

    @Test
    void message_initially_isHidden() {
        assertThat(shown).containsExactly("");
    }

    @Test
    void shortMessage_isNeverShown() {
        for (int i = 0; i < 10; i++) {
            message.set("pending");
            scheduler.advance(Duration.millis(99));
            message.set("");
        }
        scheduler.advance(Duration.seconds(1));
        assertThat(shown).containsExactly("");
    }

    @Test
    void lastingMessage_appearsAfterDelayAndHidesImmediately() {
        message.set("pending");
        scheduler.advance(Duration.millis(99));
        assertThat(shown).containsExactly("");
        scheduler.advance(Duration.millis(1));
        assertThat(shown).containsExactly("", "pending");
        message.set("");
        assertThat(shown).containsExactly("", "pending", "");
    }

    @Test
    void changedMessage_isShownImmediatelyWithoutNewDelay() {
        message.set("pending");
        scheduler.advance(Duration.millis(60));
        message.set("out of date");
        scheduler.advance(Duration.millis(40));
        assertThat(shown).containsExactly("", "out of date");
        message.set("pending");
        assertThat(shown).containsExactly("", "out of date", "pending");
    }
}
