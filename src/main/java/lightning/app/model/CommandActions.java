package lightning.app.model;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import javafx.beans.value.ObservableValue;
import lightning.edit.Command;

/** What each command does, and what those switch that switch something. */
final class CommandActions {
    private final Map<Command, Runnable> actions = new EnumMap<>(Command.class);
    private final Map<Command, ObservableValue<Boolean>> switches = new EnumMap<>(Command.class);

    void set(Command command, Runnable action) {
        actions.put(command, action);
    }

    void set(Command command, ObservableValue<Boolean> on, Runnable action) {
        switches.put(command, on);
        actions.put(command, action);
    }

    Optional<ObservableValue<Boolean>> switched(Command command) {
        return Optional.ofNullable(switches.get(command));
    }

    boolean has(Command command) {
        return actions.containsKey(command);
    }

    /** Nothing where nobody can do it. */
    void run(Command command) {
        Runnable action = actions.get(command);
        if (action != null) {
            action.run();
        }
    }
}
