/* Loads an FMU for co-simulation (FMI 2.0) and writes its outputs, one line for each instant, as hexadecimal floats.
 *
 * driver LIBRARY GUID STOP STEPS N_INPUTS [VR START]... [VR OF AN OUTPUT]...
 * Each input changes by a tenth of its start value every tenth step: a factor that every system computes alike. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include "fmi2Functions.h"
#ifdef _WIN32
#include <windows.h>
static void *open_library(const char *name) { return (void *)LoadLibraryA(name); }
static void *symbol(void *library, const char *name) { return (void *)GetProcAddress((HMODULE)library, name); }
static const char *reason(void) { static char text[40]; sprintf(text, "error %lu", GetLastError()); return text; }
#else
#include <dlfcn.h>
static void *open_library(const char *name) { return dlopen(name, RTLD_NOW | RTLD_LOCAL); }
static void *symbol(void *library, const char *name) { return dlsym(library, name); }
static const char *reason(void) { return dlerror(); }
#endif

static void say(fmi2ComponentEnvironment where, fmi2String name, fmi2Status status, fmi2String kind, fmi2String text, ...) {
    va_list rest;
    (void)where; (void)name; (void)kind;
    fprintf(stderr, "status %d: ", (int)status);
    va_start(rest, text);
    vfprintf(stderr, text, rest);
    va_end(rest);
    fputc('\n', stderr);
}

static int failed(const char *what) {
    fprintf(stderr, "%s failed\n", what);
    return 1;
}

#define FUNCTION(name) name##TYPE *name = (name##TYPE *)symbol(library, #name); \
    if (!name) return failed("finding " #name)
#define CHECKED(call) if ((call) != fmi2OK) return failed(#call)

int main(int count, char **words) {
    if (count < 6) return failed("reading the command line");
    void *library = open_library(words[1]);
    if (!library) { fprintf(stderr, "%s\n", reason()); return failed("loading"); }
    double stop = atof(words[3]);
    int steps = atoi(words[4]), n_inputs = atoi(words[5]), n_outputs = count - 6 - 2 * n_inputs;
    char **inputs = words + 6, **outputs = inputs + 2 * n_inputs;
    FUNCTION(fmi2Instantiate);
    FUNCTION(fmi2SetupExperiment);
    FUNCTION(fmi2EnterInitializationMode);
    FUNCTION(fmi2ExitInitializationMode);
    FUNCTION(fmi2SetReal);
    FUNCTION(fmi2GetReal);
    FUNCTION(fmi2DoStep);
    FUNCTION(fmi2Terminate);
    FUNCTION(fmi2FreeInstance);
    fmi2CallbackFunctions callbacks = {say, calloc, free, NULL, NULL};
    fmi2Component c = fmi2Instantiate("driven", fmi2CoSimulation, words[2], "file:///", &callbacks, fmi2False, fmi2False);
    if (!c) return failed("fmi2Instantiate");
    CHECKED(fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2True, stop));
    CHECKED(fmi2EnterInitializationMode(c));
    CHECKED(fmi2ExitInitializationMode(c));
    for (int k = 0; k <= steps; k++) {
        for (int i = 0; i < n_outputs; i++) {
            fmi2ValueReference reference = (fmi2ValueReference)strtoul(outputs[i], NULL, 10);
            double value;
            CHECKED(fmi2GetReal(c, &reference, 1, &value));
            printf(i ? " %a" : "%a", value);
        }
        putchar('\n');
        if (k == steps) break;
        for (int i = 0; i < n_inputs; i++) {
            fmi2ValueReference reference = (fmi2ValueReference)strtoul(inputs[2 * i], NULL, 10);
            double value = atof(inputs[2 * i + 1]) * ((k / 10) % 2 ? 0.9 : 1.0);
            CHECKED(fmi2SetReal(c, &reference, 1, &value));
        }
        CHECKED(fmi2DoStep(c, stop * k / steps, stop / steps, fmi2True));
    }
    CHECKED(fmi2Terminate(c));
    fmi2FreeInstance(c);
    return 0;
}
