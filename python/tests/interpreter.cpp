// Python with artcal._native built in: tests the package against libraries that are not position-independent.
#include <Python.h>

extern "C" PyObject* PyInit__native();

int main(int argc, char** argv) {
  return PyImport_AppendInittab("_native", &PyInit__native) == 0 ? Py_BytesMain(argc, argv) : 1;
}
